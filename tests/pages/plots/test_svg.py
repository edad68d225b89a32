"""Figures inside pages: accessible, in the page's colours, with ids of their own, always the same."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from pkmodes.pages.plots.style import BLUE, INK, PAPER, figure, figure_style
from pkmodes.pages.plots.svg import inline_svg

ROOT = Path(__file__).parents[3]
SVG = "{http://www.w3.org/2000/svg}"


def drawn(label: str = "a label", marks: int = 5) -> Figure:
    with figure_style():
        found = figure(2.0)
        axes = found.subplots()
        axes.plot(np.arange(marks), np.arange(marks) ** 2, "o-", label=label)
        axes.scatter([0, 1], [2, 3], facecolor=PAPER, edgecolor=INK, rasterized=marks > 100)
        axes.set_xlabel("frequency [Hz]")
        axes.legend()
    return found


def ids(root: ElementTree.Element) -> list[str]:
    return [element.attrib["id"] for element in root.iter() if "id" in element.attrib]


def test_a_figure_has_a_role_a_title_and_a_description() -> None:
    root = ElementTree.fromstring(inline_svg(drawn(), 'Title <&"', "What it shows"))
    assert root.tag == f"{SVG}svg"
    assert root.get("role") == "img"
    by_id = {element.get("id"): element for element in root.iter() if "id" in element.attrib}
    assert by_id[root.get("aria-labelledby")].text == 'Title <&"'
    assert by_id[root.get("aria-describedby")].text == "What it shows"
    assert by_id[root.get("aria-labelledby")].tag == f"{SVG}title"
    assert root.get("width") is None
    assert "width: 100%" in root.attrib["style"]
    assert "viewBox" in root.attrib


def test_ids_differ_between_figures_and_every_reference_is_met() -> None:
    pages = [
        inline_svg(drawn(), "one", ""),
        inline_svg(drawn(), "two", ""),
        inline_svg(drawn("other"), "one", ""),
    ]
    roots = [ElementTree.fromstring(page) for page in pages]
    every = [name for root in roots for name in ids(root)]
    assert len(set(every)) == len(every)
    for page, root in zip(pages, roots, strict=True):
        used = set(re.findall(r'(?:url\(|href=")#([^)"]+)', page))
        assert used
        assert used <= set(ids(root))


def test_rounding_in_the_layout_does_not_change_the_page() -> None:
    """The solver of layouts adds in an order that depends on addresses in memory."""
    pages = []
    for rounding in (0.0, 3e-13):
        made = drawn()
        made.set_layout_engine("none")
        made.axes[0].set_position((0.1, 0.2, 0.8 + rounding, 0.7 - rounding))
        pages.append(inline_svg(made, "t", "d"))
    assert "clip-path" in pages[0]
    assert pages[0] == pages[1]


def test_text_and_axes_have_the_colour_of_the_page_and_data_their_own() -> None:
    page = inline_svg(drawn(), "t", "d")
    assert INK not in page
    assert PAPER not in page
    assert "currentColor" in page
    assert f"var(--blue, {BLUE})" in page
    texts = list(ElementTree.fromstring(page).iter(f"{SVG}text"))
    assert {"a label", "frequency [Hz]"} <= {text.text for text in texts}
    for text in texts:
        assert "fill: currentColor" in text.attrib["style"]
        assert "font-family: inherit" in text.attrib["style"]


def test_a_label_that_looks_like_a_colour_or_markup_stays_as_it_is() -> None:
    for label in (BLUE, f"url(#{INK})", "</svg><script>", "$x_{$", "\u6f22\u5b57 \u05e9"):
        texts = [
            e.text for e in ElementTree.fromstring(inline_svg(drawn(label), "t", "d")).iter(f"{SVG}text")
        ]
        assert label in texts


def test_characters_that_xml_cannot_hold_are_replaced_in_title_and_description() -> None:
    root = ElementTree.fromstring(inline_svg(drawn(), "a\x00b\ud800", "c\x1bd"))
    assert [e.text for e in root[:2]] == ["a\ufffdb\ufffd", "c\ufffdd"]


def test_nothing_tells_the_date_or_reaches_outside() -> None:
    page = inline_svg(drawn(marks=500), "t", "d")
    assert "metadata" not in page
    assert "<style" not in page
    assert "DOCTYPE" not in page
    assert set(re.findall(r'https?://[^"]+', page)) == {"http://www.w3.org/2000/svg"}
    assert "data:image/png;base64," in page


def python(code: str, folder: Path | None = None, **variables: str) -> str:
    """Run Python with nothing but the sources, and return what it prints."""
    path = os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "tests/pages/plots"))
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        cwd=folder,
        env={"PYTHONPATH": path, "PATH": os.environ["PATH"], **variables},
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_same_figure_gives_the_same_text_in_every_process(tmp_path: Path) -> None:
    """Whatever the hash seed, and whatever settings of matplotlib the user has."""
    code = "from test_svg import drawn, inline_svg; import hashlib; "
    code += "print(hashlib.sha256(inline_svg(drawn(), 't', 'd').encode()).hexdigest())"
    settings = "font.size: 31\naxes.labelpad: 31\nlegend.borderpad: 3\nlines.markeredgewidth: 5\n"
    (tmp_path / "matplotlibrc").write_text(settings, encoding="utf-8")
    own = python(code, tmp_path, PYTHONHASHSEED="1", MPLCONFIGDIR=str(tmp_path))
    assert own == python(code, PYTHONHASHSEED="2", MPLCONFIGDIR=str(tmp_path / "other"))


def test_the_settings_of_the_user_are_left_alone() -> None:
    before = dict(matplotlib.rcParams)
    inline_svg(drawn(), "t", "d")
    assert dict(matplotlib.rcParams) == before


def test_no_figure_uses_the_global_state_of_pyplot(tmp_path: Path) -> None:
    code = "import sys; from test_svg import drawn, inline_svg; inline_svg(drawn(), 't', 'd'); "
    code += "print('matplotlib.pyplot' in sys.modules)"
    assert python(code, MPLCONFIGDIR=str(tmp_path)) == "False\n"


def test_the_modules_are_imported_without_the_libraries() -> None:
    """They are needed only when something is drawn."""
    names = ["plots.setup_frequencies", "plots.svg", "report", "report.page", "cli.reporting"]
    code = "import sys; sys.modules.update(dict.fromkeys(('matplotlib', 'jinja2')))"
    code += "".join(f"; import pkmodes.{name}" for name in names)
    assert python(code) == ""
