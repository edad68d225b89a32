"""Reports in a real browser: nothing is loaded or executed, everything is drawn, readable and reachable."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from helpers.diagnoses.examples import example
from helpers.diagnoses.verdict_examples import VERDICTS
from helpers.pages.browser import Opened, opened
from helpers.pages.page_reading import read
from helpers.pages.report_examples import HOSTILE, hostile_page, made_up, many_modes, page_of
from helpers.runs.shared import Shared
from pkmodes import updating
from pkmodes.cli import run
from pkmodes.pages.report import report

ROOT = Path(__file__).parents[3]
LOOP = [str(ROOT / "examples" / "closed_loop" / name) for name in ("robot.toml", "measured.csv")]
VORON = [str(ROOT / "examples" / "voron" / name) for name in ("robot.toml", "measured.csv")]
PAGES = (*VERDICTS, "compare", "load cases", "structure", "many", "hostile")
#: Every drawn element of a figure, with its box and whether it has a path.
DRAWN = """
() => [...document.querySelectorAll("figure svg[role=img]")].filter(svg => svg.checkVisibility()).map(svg => {
  const box = svg.getBoundingClientRect();
  const parts = [...svg.querySelectorAll("path, use, image, text")];
  return {
    width: box.width, height: box.height, title: svg.querySelector("title").textContent,
    empty: [...svg.querySelectorAll("path")].filter(path => path.getTotalLength() === 0).length,
    visible: parts.filter(part => { const b = part.getBoundingClientRect(); return b.width + b.height > 0; }).length,
    outside: [...svg.querySelectorAll("text")].filter(text => {
      const b = text.getBoundingClientRect();
      return b.left < box.left - 1 || b.right > box.right + 1 || b.top < box.top - 1 || b.bottom > box.bottom + 1;
    }).map(text => text.textContent),
  };
})
"""


UNFOLD = "document.querySelectorAll('details').forEach(one => { one.open = true; })"


@pytest.fixture(scope="module", params=PAGES)
def page(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, shared: Shared) -> Path:
    """The report of each kind of result, as a file."""
    folder = tmp_path_factory.mktemp("page")
    target = folder / "report.html"
    if request.param in VERDICTS:
        target.write_text(page_of(request.param, folder, shared), encoding="utf-8")
    elif request.param == "compare":
        assert run(["compare", *LOOP, "--report", str(target)]) == 0
    elif request.param == "load cases":
        assert run(["compare", *VORON, "--report", str(target)]) == 0
    elif request.param == "structure":
        result, _ = structure()
        target.write_text(report(result), encoding="utf-8")
    elif request.param == "many":
        target.write_text(many_modes(shared), encoding="utf-8")
    else:
        target.write_text(hostile_page(shared), encoding="utf-8")
    return target


@pytest.fixture(scope="module")
def shown(page: Path) -> Iterator[Opened]:
    with opened(page) as browser:
        browser.page.evaluate(UNFOLD)
        yield browser


@pytest.fixture
def seen(shown: Opened) -> Opened:
    """Each report, opened once for the tests that change only the size of the window, the colours, and the focus."""
    shown.page.set_viewport_size({"width": 1280, "height": 900})
    shown.page.emulate_media(color_scheme="light", media="screen")
    return shown


def structure() -> Any:
    """The diagnosis of the example that is no robot."""
    names: dict[str, Any] = {"__name__": "example"}
    exec((ROOT / "examples" / "lumped_structure.py").read_text(encoding="utf-8"), names)
    data = names["measure"](names["np"].random.default_rng(1))
    return names["diagnose"](names["structure"], data), data


def test_nothing_is_loaded_executed_or_complained_about(seen: Opened, page: Path) -> None:
    seen.page.wait_for_timeout(200)
    assert seen.problems == []
    # The images inside the figures are part of the file.
    assert [url for url in seen.requests if not url.startswith("data:")] == [page.as_uri()]

    def count(selector: str) -> int:
        return int(seen.page.locator(selector).count())

    assert count("iframe, img, object, script[src]") == 0
    # Data have a type.  The view in three dimensions has two programs, three.js and itself; figures share one, and
    # so do folded sections.
    assert count("script:not([type])") == 2 * count(".pkview") + 1 + min(count("details"), 1)
    assert count("[onerror], [onload], [onmouseover]") == 0
    assert "hacked" not in seen.page.title() or "<script>" in seen.page.title()


@pytest.mark.parametrize(("width", "least"), [(1280, 400), (360, 300)])
def test_every_figure_is_drawn(seen: Opened, width: int, least: int) -> None:
    seen.page.set_viewport_size({"width": width, "height": 900})
    figures = seen.page.evaluate(DRAWN)
    count = seen.page.locator(".plot").count()
    assert len(figures) == count > 0
    for figure in figures:
        assert figure["width"] > least, figure
        assert figure["height"] > 50, figure
        assert figure["visible"] > 10, figure
        assert figure["empty"] == 0, figure
        assert figure["outside"] == [], figure


def test_panels_are_stacked_on_a_phone_and_not_on_paper_or_a_desk(tmp_path: Path, shared: Shared) -> None:
    """Each box shows one layout; what is wider than the screen says so."""
    (tmp_path / "page.html").write_text(page_of("effect_found", tmp_path, shared), encoding="utf-8")
    shown = """() => [...document.querySelectorAll(".plot")].map(box => ({
      layouts: [...box.querySelectorAll("svg")].filter(svg => svg.checkVisibility()).length,
      narrow: !!box.querySelector(".narrow svg")?.checkVisibility(),
      wider: box.scrollWidth > box.clientWidth,
      said: getComputedStyle(box.nextElementSibling, "::before").content.includes("sideways"),
      small: Math.min(...[...box.querySelectorAll("svg text")].filter(text => text.checkVisibility())
        .map(text => parseFloat(getComputedStyle(text).fontSize) * Math.hypot(text.getCTM().c, text.getCTM().d))),
    }))"""
    with opened(tmp_path / "page.html", width=360) as browser:
        browser.page.evaluate(UNFOLD)
        phone = browser.page.evaluate(shown)
        assert all(one["layouts"] == 1 and one["said"] == one["wider"] for one in phone)
        assert all(one["narrow"] != one["wider"] for one in phone)
        assert sum(one["narrow"] for one in phone) >= 6
        assert min(one["small"] for one in phone if one["narrow"]) > 8  # pixels
        first = browser.page.locator("#rows tbody th").first
        before = first.bounding_box()
        browser.page.locator("#rows .box").evaluate("box => { box.scrollLeft = 200; }")
        assert before is not None
        assert first.bounding_box()["x"] == pytest.approx(before["x"], abs=1)  # type: ignore[index]
        browser.page.emulate_media(media="print")
        assert not any(one["narrow"] or one["said"] for one in browser.page.evaluate(shown))
        browser.page.emulate_media(media="screen")
        browser.page.set_viewport_size({"width": 1280, "height": 900})
        assert not any(one["narrow"] or one["said"] for one in browser.page.evaluate(shown))
        # The fitted values fit beside the contents, though the path of the cause is long.
        box = browser.page.locator("#values .box").first
        assert "gearbox_compliance.compliance" in box.inner_text().replace("\n", "")
        assert box.evaluate("box => box.scrollWidth - box.clientWidth") <= 0


def test_sections_fold_on_a_screen_and_not_on_paper(tmp_path: Path, shared: Shared) -> None:
    """What is folded can be gone to, unfolded by a key or all together; paper has it, also without programs."""
    place = tmp_path / "page.html"
    place.write_text(page_of("effect_found", tmp_path, shared), encoding="utf-8")
    visible = """() => [...document.querySelectorAll(".folded")].map(
      one => one.querySelector("p, table, svg, dd").checkVisibility({contentVisibilityAuto: true}))"""
    with opened(place) as browser:
        page = browser.page
        folded = page.evaluate(visible)
        assert len(folded) >= 8
        assert not any(folded)
        assert page.locator("#causes table").is_visible()
        page.locator("nav a[href='#candidates']").click()
        browser.until("document.querySelector('#candidates details').open")
        assert page.evaluate("document.querySelector('#candidates').getBoundingClientRect().top") < 100
        page.locator("#values summary").focus()
        page.keyboard.press("Enter")
        assert page.locator("#values table").first.is_visible()
        assert sum(page.evaluate(visible)) == 2
        page.get_by_role("button", name="Unfold all").click()
        assert all(page.evaluate(visible))
        page.get_by_role("button", name="Fold all").click()
        assert not any(page.evaluate(visible))
    with opened(place, media="print", java_script_enabled=False) as browser:
        assert browser.page.locator("#candidates table").first.is_visible()
        assert browser.page.locator("#rows table").is_visible()


def test_a_page_has_no_horizontal_scroll_at_any_width(seen: Opened) -> None:
    for width in (320, 390, 768, 1200, 1920):
        seen.page.set_viewport_size({"width": width, "height": 800})
        assert seen.page.evaluate("document.documentElement.scrollWidth") <= width


def test_axe_has_no_grave_findings_in_light_and_dark(seen: Opened) -> None:
    assert seen.findings_in_light_and_dark() == []


def test_a_page_is_dark_where_that_is_preferred(seen: Opened) -> None:
    shade = """() => ["body", "figure svg text"].map(name => {
        const style = getComputedStyle(document.querySelector(name));
        const colour = name === "body" ? style.backgroundColor : style.fill;
        return colour.match(/[0-9]+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0) / 3;
    })"""
    light, text = seen.page.evaluate(shade)
    seen.page.emulate_media(color_scheme="dark")
    dark, bright = seen.page.evaluate(shade)
    assert light > 240
    assert text < 60
    assert dark < 60
    assert bright > 200


def test_a_page_prints_on_paper_without_cutting_figures_and_rows(seen: Opened) -> None:
    seen.page.emulate_media(color_scheme="dark")
    pdf = seen.page.pdf(prefer_css_page_size=True)
    seen.page.emulate_media(media="print")
    paper = seen.page.evaluate("getComputedStyle(document.body).backgroundColor")
    hidden = seen.page.evaluate("getComputedStyle(document.querySelector('nav')).display")
    # Two figures fit on a page of A4, so that none leaves half a page blank; tall ones are still read.
    heights = seen.page.evaluate(
        "[...document.querySelectorAll('.plot:not(.tall) svg')].map(one => one.getBoundingClientRect().height)"
    )
    heads = seen.page.evaluate(
        "[...document.querySelectorAll('thead')].map(one => getComputedStyle(one).display)"
    )
    breaks = seen.page.evaluate(
        """[...document.querySelectorAll("figure:has(svg), tbody tr, .summary")]
           .map(one => getComputedStyle(one).breakInside)"""
    )
    assert pdf.startswith(b"%PDF")
    # The long names of the hostile file stand whole in every sentence that has one.
    assert 2 <= pdf.count(b"/Type /Page\n") + pdf.count(b"/Type /Page ") <= 80
    assert b"[0 0 594.95996 841.91998]" in pdf or b"[0 0 595" in pdf  # A4
    assert paper == "rgb(255, 255, 255)"
    assert hidden == "none"
    assert max(heights) <= 108 * 96 / 25.4 + 1
    assert set(heads) == {"table-header-group"}  # repeated on every page
    assert set(breaks) == {"avoid"}


def test_a_page_is_used_by_keyboard_alone(seen: Opened) -> None:
    seen.page.set_viewport_size({"width": 390, "height": 900})
    keyboard = seen.page.keyboard
    keyboard.press("Tab")
    assert seen.page.evaluate("document.activeElement.textContent") == "Skip to the content"
    assert seen.page.evaluate("document.activeElement.getBoundingClientRect().left") >= 0
    keyboard.press("Enter")
    assert seen.page.evaluate("document.activeElement.id") == "content"
    # Every box that is wider than the screen is reached, and the arrow keys move it.
    wide = seen.page.evaluate(
        "[...document.querySelectorAll('.box')].filter(b => b.scrollWidth > b.clientWidth).length"
    )
    moved, left = 0, seen.page.evaluate("document.querySelectorAll('.box').length")
    while left:
        keyboard.press("Tab")
        if seen.page.evaluate("document.activeElement.closest('.pkview') !== null"):
            continue  # the view in three dimensions has its own test
        if seen.page.evaluate("document.activeElement.closest('.save') !== null"):
            continue  # the buttons of a figure have theirs
        if seen.page.evaluate("document.activeElement.matches('summary')"):
            continue  # so have sections that fold
        assert "box" in seen.page.evaluate("document.activeElement.className")
        left -= 1
        style = "getComputedStyle(document.activeElement)"
        assert seen.page.evaluate(f"{style}.outlineStyle") == "solid"
        assert seen.page.evaluate(
            "document.activeElement.getAttribute('aria-label') || "
            "document.activeElement.getAttribute('aria-labelledby')"
        )
        if seen.page.evaluate("document.activeElement.scrollWidth > document.activeElement.clientWidth"):
            keyboard.press("ArrowRight")
            seen.until("document.activeElement.scrollLeft > 0")
            moved += 1
    assert moved == wide > 0


def test_hostile_text_is_only_text(shared: Shared) -> None:
    html = hostile_page(shared)
    page = read(html)
    assert page.all("h1")[0].text.startswith(HOSTILE[0])
    assert len(page.all("h1")) == 1
    cells = [cell.text for cell in page.by_id("rows").all("th")]
    for text in HOSTILE[:6]:
        assert text in cells
    assert not set("\u202e\u202c\u2066\u2069\x00\x07\x1b") & set(html)
    assert "\\u202egnitset\\u202c" in html
    assert len(html.encode("utf-8")) < 600_000


def test_the_closed_loop_report_is_small(
    tmp_path: Path, shared: Shared, monkeypatch: pytest.MonkeyPatch
) -> None:
    target, found = tmp_path / "report.html", example(shared, "closed_loop")
    monkeypatch.setattr(updating, "diagnose", lambda *_, **__: found)
    assert run(["diagnose", *LOOP, "--report", str(target)]) == 0
    assert 100_000 < target.stat().st_size < 1_500_000  # 0.6 MB of them are three.js


@pytest.mark.usefixtures("no_drawing")
def test_a_hostile_title_is_shown_as_it_is() -> None:
    result, data = made_up(12, 3, labels=HOSTILE, names=HOSTILE)
    (title,) = read(report(result, data=data, title=HOSTILE[0])).all("h1")
    assert title.text == HOSTILE[0]


@pytest.mark.usefixtures("no_drawing")
def test_a_view_is_placed_as_it_is() -> None:
    result = updating.compare(*loop())
    html = report(result, view="<div id='three'><canvas></canvas></div>")
    section = read(html).by_id("view")
    assert section.all("canvas")
    assert "view" not in read(report(result)).ids()


def loop() -> Any:
    from pkmodes import read_robot

    robot = read_robot(LOOP[0])
    return robot, updating.read(LOOP[1], None, robot)
