"""Figures of a report are saved from the page: as PNG, and their numbers as CSV."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.pages.browser import opened
from helpers.pages.report_examples import HOSTILE
from pkmodes.cli import run
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import visible_text
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.report.blocks import Picture, Section, Summary
from pkmodes.pages.report.page import page

ROOT = Path(__file__).parents[3]
LOOP = [ROOT / "examples" / "closed_loop" / name for name in ("robot.toml", "measured.csv")]
X = np.linspace(0.1, 3.0, 40)
NUMBERS = {name: np.exp(-X) * np.cos(7.0 * X + k) for k, name in enumerate(("measured", "model"))}


def figure(title: str, model: str) -> Picture:
    """A figure of `NUMBERS`, with a name for the second series."""

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(2.5)
        for name, values in zip(("measured", model), NUMBERS.values(), strict=True):
            panel.plot(X, values, label=visible_text(name, 60))  # as every figure does
        panel.label(x="frequency [Hz]", y="size [\u03c3]")
        panel.axes.legend()

    return Picture.from_drawing(Drawing(draw), visible_text(title), "two curves", "Two curves.")


def written(folder: Path, *figures: Picture) -> Path:
    """Write a page with figures, by default one."""
    blocks = list(figures) or [figure("Two curves", "model")]
    html = page(Summary("robot", "Test", "", "Two curves", "", "plain"), [Section("one", "One", blocks)])
    (folder / "page.html").write_text(html, encoding="utf-8")
    return folder / "page.html"


def saved(browser: Any, form: str, folder: Path, number: int = 0) -> Path:
    """Press a button of a figure, and return the file that the browser saves."""
    browser.page.evaluate("document.querySelectorAll('details').forEach(fold => { fold.open = true; })")
    with browser.page.expect_download() as waiting:
        browser.page.locator(".save").nth(number).locator("button", has_text=form).click()
    target = folder / waiting.value.suggested_filename
    waiting.value.save_as(target)
    return target


def rows_of(file: Path) -> list[dict[str, str]]:
    text = file.read_bytes().decode("utf-8")
    assert text[0] == "\ufeff"  # spreadsheets take it for UTF-8
    return list(csv.DictReader(io.StringIO(text[1:], newline="")))


def test_the_numbers_of_a_figure_are_saved_as_they_were_drawn(tmp_path: Path) -> None:
    with opened(written(tmp_path)) as browser:
        file = saved(browser, "CSV", tmp_path)
        assert browser.problems == []
        assert browser.outside == []
    assert file.name == "two-curves.csv"
    rows = rows_of(file)
    for name, values in NUMBERS.items():
        own = [row for row in rows if row["series"] == name]
        assert [float(row["frequency [Hz]"]) for row in own] == X.tolist()
        assert [float(row["size [\u03c3]"]) for row in own] == values.tolist()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_picture_is_saved_on_white_paper_in_the_colours_of_the_light_page(
    scheme: Any, tmp_path: Path
) -> None:
    from PIL import Image

    with opened(written(tmp_path), scheme=scheme) as browser:
        box = browser.page.evaluate(
            "[...'wh'].map((_, i) => "
            "{ const b = document.querySelector('figure svg').viewBox.baseVal; return i ? b.height : b.width; })"
        )
        file = saved(browser, "PNG", tmp_path)
        assert browser.problems == []
    pixels = np.asarray(Image.open(file).convert("RGB")).astype(int)
    # 300 dots per inch of 72 units.
    assert pixels.shape[1::-1] == tuple(round(side * 300 / 72) for side in box)
    assert (pixels[0] == 255).all()
    assert (pixels == 255).all(axis=2).mean() > 0.5
    for colour in ((0x00, 0x72, 0xB2), (0xD5, 0x5E, 0x00), (0x1B, 0x1E, 0x22)):  # blue, vermillion, ink
        assert (np.abs(pixels - colour).max(axis=2) <= 2).sum() > 100


def test_buttons_have_names_and_work_by_the_keyboard(tmp_path: Path) -> None:
    with opened(written(tmp_path)) as browser:
        for form in ("PNG", "CSV"):
            button = browser.page.get_by_role("button", name=f"Save Two curves as {form}")
            button.focus()
            with browser.page.expect_download() as waiting:
                browser.page.keyboard.press("Enter")
            assert waiting.value.suggested_filename == f"two-curves.{form.lower()}"
        assert browser.findings() == []


def test_buttons_are_not_printed_and_need_the_program(tmp_path: Path) -> None:
    file = written(tmp_path)
    with opened(file, media="print") as browser:
        assert not browser.page.locator(".save").is_visible()
    with opened(file, java_script_enabled=False) as browser:
        assert browser.page.locator("button").count() == 0
        shown = browser.page.locator("figure svg").all()
        assert [one.is_visible() for one in shown] == [True, False]  # the other is for narrow screens


def test_hostile_names_give_files_with_plain_names_and_no_formulas(
    subtests: pytest.Subtests, tmp_path: Path
) -> None:
    texts = [*HOSTILE, "=1+1", "-2", "@SUM(A1)", "../../etc/passwd", "."]
    with opened(written(tmp_path, *(figure(text, text) for text in texts))) as browser:
        for k, text in enumerate(texts):
            with subtests.test(ascii(text[:40])):
                file = saved(browser, "CSV", tmp_path, k)
                assert saved(browser, "PNG", tmp_path, k).stat().st_size > 1000
                stem = file.name.removesuffix(".csv")
                assert all(part.isalnum() for part in stem.split("-"))
                assert len(stem) <= 60
                rows = rows_of(file)
                assert len(rows) == 2 * len(X)
                assert not [cell for row in rows for cell in row.values() if cell[:1] in ("=", "+", "@")]
                np.testing.assert_array_equal(
                    [float(row["size [\u03c3]"]) for row in rows], np.hstack([*NUMBERS.values()])
                )
        assert browser.problems == []


def test_the_figures_of_a_comparison_have_the_measured_frequencies(tmp_path: Path) -> None:
    target = tmp_path / "report.html"
    assert run(["compare", *map(str, LOOP), "--report", str(target)]) == 0
    with LOOP[1].open(encoding="utf-8") as file:
        lines = [line for line in file if not line.startswith("#")]
    measured = sorted(float(row["frequency"]) for row in csv.DictReader(lines))
    with opened(target) as browser:
        figures = browser.page.locator("figure:has(.plot)").count()
        assert browser.page.locator(".save").count() == figures
        titles = browser.page.locator("figure:has(.plot) .wide svg > title").all_text_contents()
        rows = rows_of(saved(browser, "CSV", tmp_path, titles.index("Frequencies at each pose")))
        assert browser.problems == []
    drawn = [float(row["frequency [Hz]"]) for row in rows if row["series"] in ("measured mode", "unmatched")]
    assert sorted(drawn) == measured
