"""The documentation as a site: built without a warning, complete, and usable by everyone without a network."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urljoin, urlsplit

import pytest

from helpers.pages.browser import opened, served
from helpers.pages.documentation import PAGES, ROOT
from helpers.runs.shared import Shared

pytestmark = pytest.mark.slow

#: The landing page, prose with pictures, an API page, one with formulas, tables, and generated ones.
SHOWN = [
    "index",
    "tutorial/gallery",
    "tutorial/tutorial",
    "reference/api/pkmodes",
    "derivation/corexy",
    "reference/robot-file",
    "reference/command-line",
    "reference/json-schemas",
]
#: Pages with long formulas, tables and code, which also fit a phone.
WIDE = [
    "derivation/rotary_delta",
    "reference/verdicts",
    "explanation/published-tables",
    "explanation/compiled",
]
#: Builds as ``make docs`` does, but for the figures in the samples of the gallery, which their own tests draw.
BUILD = """
import sys
from sphinx.cmd.build import main
from helpers.pages.without_drawing import without_drawing
with without_drawing():
    sys.exit(main(sys.argv[1:]))
"""
#: Where the digital object identifiers lead: nothing else outside is linked without a reason.
OUTSIDE = {"doi.org", "pint.readthedocs.io", "github.com", "docs.xarray.dev", "semver.org"}
OUTSIDE |= {"docs.dask.org", "jobqueue.dask.org", "kubernetes.dask.org"}
LATEX = re.compile(r"\\[a-zA-Z]+|\$")


@pytest.fixture(scope="module")
def site(shared: Shared) -> Path:
    return shared.folder("site", built) / "html"


def built(folder: Path) -> None:
    options = [
        "--fail-on-warning",
        "--keep-going",
        "--quiet",
        "-d",
        str(folder / "doctrees"),
        "-c",
        "docs/site",
    ]
    run = subprocess.run(
        [sys.executable, "-c", BUILD, *options, "docs", str(folder / "html")],
        cwd=ROOT,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    assert not run.stderr


@pytest.fixture(scope="module")
def address(site: Path) -> Iterator[str]:
    with served(site) as url:
        yield url


class Parsed(HTMLParser):
    """Identifiers, links, and the text of an HTML page outside code."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: set[str] = set()
        self.links: list[str] = []
        self.formulas = 0
        self.text = ""
        self._open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = dict(attrs)
        if found.get("id"):
            self.ids.add(str(found["id"]))
        self.links += [str(found[key]) for key in ("href", "src") if found.get(key)]
        self.formulas += tag == "math"
        if tag in ("pre", "code", "script", "style", "title"):
            self._open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if self._open and self._open[-1] == tag:
            self._open.pop()

    def handle_data(self, data: str) -> None:
        if not self._open:
            self.text += data


@pytest.fixture(scope="module")
def parsed(site: Path) -> dict[Path, Parsed]:
    return {path: Parsed(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}


def test_every_page_of_the_documentation_is_on_the_site(parsed: dict[Path, Parsed], site: Path) -> None:
    for page in PAGES:
        if page.startswith("docs/"):
            path = site / page.removeprefix("docs/").replace(".md", ".html")
            assert path in parsed, page


def test_every_link_leads_somewhere(parsed: dict[Path, Parsed], site: Path) -> None:
    for path, page in parsed.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme:
                assert parts.scheme in ("https", "http", "data"), (path.name, link)
                assert parts.scheme == "data" or parts.netloc, (path.name, link)
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            assert target.is_file(), (path.relative_to(site), link)
            if parts.fragment and target in parsed:
                assert unquote(parts.fragment) in {*parsed[target].ids, ""}, (path.relative_to(site), link)


def test_external_links_are_few_and_known(parsed: dict[Path, Parsed]) -> None:
    found = {urlsplit(link).netloc for page in parsed.values() for link in page.links} - {""}
    assert found - {"www.sphinx-doc.org", "pradyunsg.me"} <= OUTSIDE  # the footer of the theme
    assert (
        "https://doi.org/10.3390/robotics10040132"
        in parsed[next(p for p in parsed if p.name == "paper.html")].links
    )


def test_formulas_are_typeset(parsed: dict[Path, Parsed], site: Path) -> None:
    """Every formula became MathML: no LaTeX is left in the text."""
    for path in (ROOT / "docs/derivation").glob("*.md"):
        page = parsed[site / "derivation" / f"{path.stem}.html"]
        source = path.read_text(encoding="utf-8")
        assert page.formulas >= source.count("```math") + source.count("$`") > 50
        assert not LATEX.findall(page.text)


@pytest.mark.parametrize("page", SHOWN)
def test_a_page_is_accessible_and_loads_nothing_from_elsewhere(address: str, page: str) -> None:
    with opened(f"{address}/{page}.html") as found:
        assert not found.findings_in_light_and_dark()
    assert not found.problems
    assert all(request.startswith((address, "data:", "blob:")) for request in found.requests)


@pytest.mark.parametrize("page", [*SHOWN, *WIDE])
def test_a_page_fits_a_phone(address: str, page: str) -> None:
    """Only formulas, tables and code scroll sideways, and the keyboard reaches those that do."""
    with opened(f"{address}/{page}.html", width=390, height=844) as found:
        assert found.page.evaluate("document.documentElement.scrollWidth") <= 390
        unreachable = found.page.evaluate(
            """[...document.querySelectorAll("article *")].filter(part =>
                part.scrollWidth > part.clientWidth + 1 && part.clientWidth > 0
                && ["auto", "scroll"].includes(getComputedStyle(part).overflowX)
                && part.tabIndex < 0).map(part => part.outerHTML.slice(0, 80))"""
        )
        assert not unreachable


def test_what_the_robot_file_defines_is_found_there_first(address: str) -> None:
    for word in ("payload", "gearbox_compliance", "gravity"):
        with opened(f"{address}/search.html?q={word}") as found:
            found.page.wait_for_selector("ul.search li a")
            first = found.page.eval_on_selector("ul.search li a", "link => link.href")
        assert "/robot-file.html#defined-" in first, word


def test_every_sample_of_the_gallery_is_live(address: str, site: Path, parsed: dict[Path, Parsed]) -> None:
    gallery = parsed[site / "tutorial/gallery.html"]
    samples = [link.removeprefix("../") for link in gallery.links if link.startswith("../samples/")]
    commands = re.findall(
        r"^```\{sample\} (\S+)$", (ROOT / "docs/tutorial/gallery.md").read_text("utf-8"), re.MULTILINE
    )
    assert samples == [f"samples/{name}" for name in commands]
    for sample in samples:
        if sample.endswith(".html"):
            with opened(f"{address}/{sample}", motion="reduce") as found:
                assert found.page.inner_text("h1")
                found.page.wait_for_timeout(500)
            assert not found.problems, sample
            assert not found.outside, sample


def test_pictures_are_drawn(address: str) -> None:
    with opened(f"{address}/tutorial/tutorial.html") as found:
        widths = found.page.evaluate("[...document.querySelectorAll('article img')].map(i => i.naturalWidth)")
    assert len(widths) >= 3
    assert all(width > 100 for width in widths)


def test_a_long_formula_is_broken_between_its_terms(address: str) -> None:
    with opened(f"{address}/derivation/rotary_delta.html", width=600) as found:
        lines = found.page.evaluate(
            """Math.max(...[...document.querySelectorAll(".formula")].map(
                f => new Set([...f.children].map(m => Math.round(m.getBoundingClientRect().bottom / 20))).size))"""
        )
    assert lines > 3


@pytest.mark.parametrize("from_files", [True, False])
def test_the_search_finds_a_word_without_a_network(address: str, site: Path, from_files: bool) -> None:
    start = f"{site.as_uri()}/" if from_files else f"{address}/"
    with opened(urljoin(start, "search.html?q=wind-up")) as found:
        found.page.wait_for_selector("ul.search li a")
        results = found.page.eval_on_selector_all("ul.search li a", "links => links.map(l => l.href)")
    assert any("robot-file" in result or "model" in result for result in results)
    assert all(request.startswith((start, "data:")) for request in found.requests)
