"""Links between the pages in the repository, as GitHub follows them, and references to the paper."""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise
from urllib.parse import unquote, urlsplit

import pytest
from markdown_it import MarkdownIt

from helpers.pages.documentation import PAGES, ROOT

DOI = "https://doi.org/10.3390/robotics10040132"
PAPER = re.compile(r"\bthe\s+paper\b", re.IGNORECASE)


@cache
def anchors(page: str) -> frozenset[str]:
    """Return the anchors that GitHub gives to the headings of a page."""
    tokens = MarkdownIt("commonmark").parse((ROOT / page).read_text(encoding="utf-8"))
    found: dict[str, int] = {}
    for opening, content in pairwise(tokens):
        if opening.type == "heading_open":
            text = "".join(part.content for part in content.children or [])
            slug = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
            found[slug] = found.get(slug, -1) + 1
            if found[slug]:
                found[f"{slug}-{found[slug]}"] = 0
    return frozenset(found)


def links(page: str) -> list[str]:
    """Return the targets of the links and pictures of a page."""
    tokens = MarkdownIt("commonmark").enable("table").parse((ROOT / page).read_text(encoding="utf-8"))
    parts = [part for token in tokens for part in token.children or []]
    return [
        str(part.attrGet("href") or part.attrGet("src"))
        for part in parts
        if part.type in ("link_open", "image")
    ]


def test_the_links_of_a_page_lead_somewhere(subtests: pytest.Subtests) -> None:
    for page in PAGES:
        with subtests.test(page=page):
            for link in links(page):
                parts = urlsplit(link)
                if parts.scheme or parts.netloc:
                    assert (parts.scheme, bool(parts.netloc)) == ("https", True), link
                    continue
                target = (ROOT / page).parent / unquote(parts.path) if parts.path else ROOT / page
                assert target.exists(), link
                name = target.resolve().relative_to(ROOT).as_posix()
                if parts.fragment:
                    assert unquote(parts.fragment) in anchors(name), link


def test_the_first_mention_of_the_paper_leads_to_its_reference(subtests: pytest.Subtests) -> None:
    for page in PAGES:
        with subtests.test(page=page):
            text = (ROOT / page).read_text(encoding="utf-8")
            prose = re.sub(r"```.*?```|<!--.*?-->", "", text, flags=re.DOTALL)
            if DOI in text or not (first := PAPER.search(prose)):
                continue
            linked = re.compile(
                r"\[[^]]*\bthe\s+paper\b[^]]*\]\((?:[\w./-]*paper\.md|[\w./]*#references)\)",
                re.IGNORECASE,
            )
            found = linked.search(prose)
            assert found is not None
            assert found.start() <= first.start() < found.end()
            assert DOI in (ROOT / "docs/explanation/paper.md").read_text(encoding="utf-8")
