"""The interactive map of a report: its numbers are those of the map, and it is used by pointer and by keyboard."""

from __future__ import annotations

import base64
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.pages.browser import Opened, opened
from helpers.pages.page_reading import NO_BREAK_SPACE
from pkmodes.cli import run
from pkmodes.machine.maps.poses import Poses
from pkmodes.pages.plots.plane import Plane
from pkmodes.pages.report.map import map_report
from pkmodes.pages.report.map_planes import section_of
from pkmodes.pages.report.map_values import pack_frequencies, pack_map

ROBOT = "robots/linear-delta-2022.toml"
GRID = {
    "x": np.linspace(0.3, 0.9, 13),
    "y": np.linspace(-0.1, 0.1, 9),
    "z": np.array([-0.3, -0.25, -0.245, -0.2]),
}
HOSTILE = ("</script><img src=x onerror=alert(1)>", '"><b>bold</b>', "\u202eright to left", "d" * 300)
COUNT = "document.querySelectorAll('[data-part=rows] tr').length"


def page_of(model: pkmodes.Model, dataset: Any, folder: Path, name: str) -> Path:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pkmodes.pages.report.map._figure_sections", lambda *_: [])  # they have their own tests
        (folder / name).write_text(map_report(model, dataset), encoding="utf-8")
    return folder / name


@pytest.fixture(scope="module")
def mapped(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Any]:
    model = pkmodes.load(ROBOT)
    found = model.map(GRID, sweep={"platform.mass": [1.0, 2.0]})
    return page_of(model, found, tmp_path_factory.mktemp("map"), "map.html"), found


def started(browser: Opened) -> Opened:
    browser.until("document.querySelector('.explorer')?.explorer !== undefined")
    browser.page.evaluate(
        "window.poses = []; document.addEventListener('pkmodes-pose', (e) => poses.push(e.detail.pose))"
    )
    return browser


def moved(browser: Opened, slider: str, value: int) -> None:
    browser.page.evaluate(
        "([name, value]) => { const one = [...document.querySelectorAll('.explorer-slider')]"
        ".find((label) => label.querySelector('bdi').textContent === name).querySelector('input');"
        "one.value = value; one.dispatchEvent(new Event('input', { bubbles: true })); }",
        [slider, value],
    )


def texts(browser: Opened, part: str) -> list[str]:
    return [text.strip() for text in browser.page.locator(f"[data-part={part}]").all_inner_texts()]


def test_every_number_shown_is_that_of_the_map(mapped: tuple[Path, Any]) -> None:
    page, found = mapped
    rng = np.random.default_rng(3)
    valid = np.argwhere(found["valid"].values)
    with opened(page) as browser:
        started(browser)
        for mass, z, y, x in rng.choice(valid, 12, replace=False):
            for name, value in (("platform.mass", mass), ("x", 6), ("y", 4), ("z", z), ("y", y), ("x", x)):
                moved(browser, name, int(value))
            if texts(browser, "status")[0].endswith("that can be evaluated."):
                moved(browser, "y", int(y))
            one = found.isel({"platform.mass": mass, "z": z, "y": y, "x": x})
            place = [float(one[name]) for name in "xyz"]
            assert browser.page.evaluate("poses.at(-1)") == pytest.approx(place, abs=1e-12)
            assert texts(browser, "frequency") == [f"{value:.3f}" for value in one["frequency"].values]
            shown = ", ".join(f"{name}\u00a0{1e3 * float(one[name]):.1f}\u00a0mm" for name in "xyz")
            assert texts(browser, "pose")[0].replace("\u2212", "-") == shown
        assert browser.problems == []
        assert browser.outside == []


@pytest.mark.parametrize("which", ["any", "chosen"])
def test_where_a_frequency_is(mapped: tuple[Path, Any], which: str) -> None:
    page, found = mapped
    frequency = found["frequency"].isel({"platform.mass": 0}).values.reshape(-1, 6)
    valid = found["valid"].isel({"platform.mass": 0}).values.reshape(-1)
    searched = frequency if which == "any" else frequency[:, 1:2]
    away = np.nanmin(np.abs(searched - 60.0), axis=1, initial=np.inf)
    inside = valid & (away <= 2.5)
    assert not np.any(np.abs(away - 2.5) < 1e-3)  # none is inside only by rounding
    with opened(page) as browser:
        started(browser)
        browser.page.locator("[data-part=mode]").nth(1).check()
        browser.page.locator("[data-part=which]").select_option(which)
        browser.page.locator("[data-part=width]").fill("2.5")
        browser.page.locator("[data-part=target]").fill("60")
        who = "A mode" if which == "any" else "Mode 2"
        share = f"{100 * inside.sum() / valid.sum():.3g}"
        assert texts(browser, "share") == [
            f"{who} lies within 57.5 to 62.5 Hz at {inside.sum()} of {valid.sum()} poses of this robot: {share} %."
        ]
        rows = [row.split() for row in browser.page.locator("[data-part=rows] tr").all_inner_texts()]
        nearest = np.sort(away[inside])[:20]
        assert len(rows) == min(20, inside.sum())
        assert [abs(float(row[-1].replace("\u2212", "-"))) for row in rows] == pytest.approx(
            nearest, abs=5.1e-4
        )
        for row in rows[:5]:
            x, y, z = (float(text.replace("\u2212", "-")) / 1e3 for text in row[:3])
            one = found["frequency"].isel({"platform.mass": 0}).sel(x=x, y=y, z=z, method="nearest")
            assert row[4] == f"{float(one.sel(mode=int(row[3]))):.3f}"
        browser.page.locator("[data-part=rows] button").first.click()
        goal = [float(text.replace("\u2212", "-")) / 1e3 for text in rows[0][:3]]
        assert browser.page.evaluate("poses.at(-1)") == pytest.approx(goal, abs=5.1e-5)
        assert browser.page.locator("[data-part=rows] tr[aria-current]").count() == 1
        assert any("in the band" in text for text in texts(browser, "in"))


def test_the_pointer_reads_and_a_click_moves_the_machine(mapped: tuple[Path, Any]) -> None:
    page, found = mapped
    with opened(page) as browser:
        started(browser)
        canvas = browser.page.locator("canvas")
        canvas.scroll_into_view_if_needed()
        box = canvas.bounding_box()
        assert box is not None
        x, y = browser.page.evaluate(
            "(() => { const { chart } = document.querySelector('.explorer').explorer;"
            "return [chart.xPixel(50), chart.yPixel(500)]; })()"
        )
        browser.page.mouse.move(box["x"] + x, box["y"] + y)
        assert texts(browser, "where") == ["At the pointer"]
        z = section_of(pkmodes.load(ROBOT), found).plane.axes["z"][0]
        here = found.isel({"platform.mass": 0}).sel(x=0.5, y=0.05, z=z, method="nearest")
        assert texts(browser, "frequency") == [f"{value:.3f}" for value in here["frequency"].values]
        assert browser.page.evaluate("poses.length") == 0
        browser.page.mouse.click(box["x"] + x, box["y"] + y)
        browser.page.mouse.move(0, 0)
        assert texts(browser, "where") == ["At the cursor"]
        assert texts(browser, "frequency") == [f"{value:.3f}" for value in here["frequency"].values]
        assert browser.page.evaluate("poses") == [pytest.approx([0.5, 0.05, z], abs=1e-9)]


def test_the_cursor_follows_the_keyboard_and_the_machine(mapped: tuple[Path, Any]) -> None:
    page, found = mapped
    with opened(page) as browser:
        started(browser)
        browser.page.locator("canvas").focus()
        at = section_of(pkmodes.load(ROBOT), found).plane.axes["z"][0]
        level = found["z"].values.tolist().index(at)
        reached = found["valid"].isel({"platform.mass": 0, "z": level, "y": 4}).values
        start = 6
        for _ in range(12):
            browser.page.keyboard.press("ArrowUp")
        last = float(found["x"].values[np.flatnonzero(reached)[-1]])
        assert browser.page.evaluate("poses.at(-1)[0]") == pytest.approx(last)
        assert browser.page.evaluate("poses.length") == reached[start + 1 :].sum()
        assert texts(browser, "status") == ["There is no further pose in this direction."]
        browser.page.keyboard.press("PageDown")
        assert browser.page.evaluate("poses.at(-1)[2]") == pytest.approx(found["z"].values[level - 1])
        count = browser.page.evaluate("poses.length")
        browser.page.evaluate(
            "document.dispatchEvent(new CustomEvent('pkmodes-moved', { detail: { pose: [0.41, -0.03, -0.21] } }))"
        )
        assert (
            "x\u00a0400.0\u00a0mm, y\u00a0\u221225.0\u00a0mm, z\u00a0\u2212200.0" in texts(browser, "pose")[0]
        )
        assert browser.page.evaluate("poses.length") == count  # it does not answer the machine


def test_it_opens_in_the_section_of_the_figures_with_their_axes(mapped: tuple[Path, Any]) -> None:
    """The section is that of `plane_of`; of x and y there, the longer is upright as the figures draw it."""
    page, found = mapped
    model = pkmodes.load(ROBOT)
    places = section_of(model, found).plane
    assert places is not None
    drawn = Plane.of(model.map(places), ["x", "y", "z"])
    with opened(page) as browser:
        started(browser)
        explorer = "document.querySelector('.explorer').explorer"
        assert browser.page.evaluate(f"{explorer}.map.pose({explorer}.poseIndex)[2]") == pytest.approx(
            drawn.normal_position
        )
        names = browser.page.evaluate(f"{explorer}.drawn.map((k) => {explorer}.data.components[k].name)")
        assert names == [drawn.abscissa, drawn.ordinate] == ["y", "x"]


def test_a_slider_does_not_reset_another(mapped: tuple[Path, Any]) -> None:
    """Where the pose is out of reach the others give way, and return as soon as it can be reached again."""
    page, found = mapped
    valid = found["valid"].isel({"platform.mass": 0})  # z, y, x
    z, y, x = next(
        (int(z), int(y), int(x))
        for z, y, x in np.argwhere(valid.values)
        if not valid.values[z, :, x].all() and valid.values[z].any(axis=1).all()
    )
    out = int(np.flatnonzero(~valid.values[z, :, x])[0])
    with opened(page) as browser:
        started(browser)
        for name, value in (("z", z), ("y", y), ("x", x)):
            moved(browser, name, value)
        set_to = [float(found[name].values[i]) for name, i in zip("xyz", (x, y, z), strict=True)]
        assert browser.page.evaluate("poses.at(-1)") == pytest.approx(set_to)
        moved(browser, "y", out)
        assert browser.page.evaluate("poses.at(-1)") != pytest.approx(set_to, abs=1e-9)
        moved(browser, "y", y)
        assert browser.page.evaluate("poses.at(-1)") == pytest.approx(set_to)


def test_a_list_of_poses_is_linked_whatever_its_labels(tmp_path: Path) -> None:
    model = pkmodes.load(ROBOT)
    table = np.array([[0.5, 0.0, -0.245], [0.6, 0.05, -0.245], [9.0, 0.0, -0.2], [0.7, -0.05, -0.2]])
    found = model.map(Poses(table, ("x", "y", "z"), HOSTILE))
    with opened(page_of(model, found, tmp_path, "list.html"), width=360) as browser:
        started(browser)
        assert browser.page.evaluate(COUNT) == 3  # the third is out of reach
        buttons = browser.page.locator("[data-part=rows] button")
        assert buttons.first.inner_text() == HOSTILE[0]
        buttons.nth(2).click()
        assert browser.page.evaluate("poses") == [pytest.approx(table[3], abs=1e-9)]
        assert texts(browser, "frequency") == [f"{value:.3f}" for value in found["frequency"].values[3]]
        browser.page.locator("canvas").focus()
        browser.page.keyboard.press("ArrowLeft")
        assert browser.page.evaluate("poses.at(-1)") == pytest.approx(table[1], abs=1e-9)
        assert not browser.sideways
        assert browser.page.locator(".explorer img, .explorer b b").count() == 0
        assert browser.problems == []
        assert browser.findings() == []


@pytest.mark.parametrize(("width", "scheme"), [(1280, "light"), (360, "dark")])
def test_it_is_accessible_on_desk_and_phone(mapped: tuple[Path, Any], width: int, scheme: Any) -> None:
    with opened(mapped[0], width=width, scheme=scheme) as browser:
        started(browser)
        browser.page.locator("[data-part=target]").fill("50")
        assert browser.page.evaluate(COUNT) == 20
        assert browser.findings() == []
        assert not browser.sideways
        assert browser.problems == []
        drawn = browser.page.evaluate(
            "(() => { const c = document.querySelector('.explorer canvas'); const d = c.getContext('2d')"
            ".getImageData(0, 0, c.width, c.height).data; const seen = new Set();"
            "for (let i = 0; i < d.length; i += 4)"
            " if (d[i + 3] === 255) seen.add(d[i] << 16 | d[i + 1] << 8 | d[i + 2]);"
            "return seen.size; })()"
        )
        assert drawn > 30  # colours of the scale
        browser.page.emulate_media(media="print")
        assert not browser.page.locator("#explore").is_visible()


def test_without_javascript_the_page_says_so(mapped: tuple[Path, Any]) -> None:
    with opened(mapped[0], java_script_enabled=False) as browser:
        assert "needs JavaScript" in browser.page.locator("#explore").inner_text()
        assert not browser.page.locator(".explorer canvas").is_visible()


def decoded(packed: str, shape: tuple[int, ...]) -> Any:
    """Undo `pack` by its description, with whole numbers of any size."""
    raw, count = zlib.decompress(base64.b64decode(packed)), int(np.prod(shape))
    first = -(-count // 8)
    bits = "".join(f"{byte:08b}" for byte in raw[:first])
    values, held = [], 0
    for i in range(count):
        code = sum(raw[first + plane * count + i] << 8 * plane for plane in range(4))
        change = -(code + 1) // 2 if code & 1 else code // 2
        held = change + (held if i % shape[-1] else 0)
        values.append(float("nan") if bits[i] == "1" else held / 1000)
    return np.array(values).reshape(shape)


def test_packed_frequencies_are_exact_to_three_decimals() -> None:
    rng = np.random.default_rng(8)
    given = rng.normal(60.0, 200.0, (3, 5, 7))  # unstable modes have negative frequencies
    given[:, 1, :3] = np.nan
    given[2, 3, 6], given[1, 2, 0] = 9e9, -9e9
    shown = decoded(pack_frequencies(given), given.shape)
    np.testing.assert_array_equal(np.isnan(shown), np.isnan(given))
    np.testing.assert_allclose(shown, np.clip(given, -1e6, 1e6), rtol=0.0, atol=0.0005 + 1e-9)


def test_a_large_map_is_thinned_and_says_so(tmp_path: Path) -> None:
    model = pkmodes.load("robots/corexy-printer.toml")
    found = model.map({"x": np.linspace(0.05, 0.25, 40), "y": np.linspace(0.05, 0.25, 21)})
    held = pack_map(found, max_values=600)
    assert held.thinned
    assert held.dataset["frequency"].size <= 600
    np.testing.assert_array_equal(
        held.dataset["frequency"].values,
        found["frequency"].values[:: held.steps["y"], :: held.steps["x"]],
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pkmodes.pages.report.explorer.pack_map", lambda one: pack_map(one, max_values=600))
        text = page_of(model, found, tmp_path, "thin.html").read_text(encoding="utf-8")
    sizes = held.dataset.sizes
    assert f"This page holds {sizes['y'] * sizes['x']} of the 840 poses of the map: every " in text
    small = pack_map(found, max_length=400)
    assert len(small.packed) <= 400


@pytest.mark.parametrize(
    ("robot", "options", "robot_shown"),
    [
        ("robots/corexy-printer.toml", ["--path", "0.02,0.02;0.2,0.05"], ""),
        ("robots/linear-delta-2022.toml", ["--grid", "x=0.4:0.6:6,y=0.02,z=-0.245", "--drives", "held"], ""),
        (
            "robots/corexy-printer.toml",
            ["--grid", "x=0.02:0.2:4,y=0.1", "--set", "toolhead.mass=0.2:0.5:2"],
            ": the robot as declared, with toolhead.mass = 0.5 kg",
        ),
    ],
)
def test_the_cursor_and_the_view_begin_at_one_pose(
    robot: str, options: list[str], robot_shown: str, tmp_path: Path
) -> None:
    page = tmp_path / "page.html"
    assert run(["map", robot, *options, "--report", str(page)]) == 0
    with opened(page) as browser:
        browser.page.wait_for_function("document.querySelector('.explorer').explorer")
        cursor = browser.page.evaluate(
            "(() => { const e = document.querySelector('.explorer').explorer; "
            "return e.map.pose(e.poseIndex); })()"
        )
        state = browser.page.evaluate(
            "(() => { const s = document.querySelector('.pkview').viewer.state; "
            "return [s.pose, s.exact]; })()"
        )
        assert state == [pytest.approx(cursor, abs=2e-6), True]
        text = browser.page.locator("main").inner_text().replace(NO_BREAK_SPACE, " ")
        assert f"The machine in its modes{robot_shown}. It moves" in text
