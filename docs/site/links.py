"""Links to pages that are written as file names, which suits GitHub and a terminal, get the titles of the pages."""

from __future__ import annotations

import re

from sphinx.application import Sphinx

#: ``[model.md](model.md#signs)`` in a page.
NAMED = re.compile(r"\[[\w/-]+\.md\](?=\([\w/.-]+\.md(#[\w-]+)?\))")
#: ``docs/model.md`` in a docstring.
PAGE = re.compile(r"\bdocs/([\w/-]+)\.md\b")


def title_links(app: Sphinx, document: str, source: list[str]) -> None:
    """Leave the text of such links to Sphinx, which takes the title of the page or section."""
    source[0] = NAMED.sub("[]", source[0])


def link_pages(app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]) -> None:
    """Turn names of pages in a docstring into links."""
    lines[:] = [PAGE.sub(r":doc:`/\1`", line) for line in lines]


def setup(app: Sphinx) -> dict[str, bool]:
    """Register both."""
    app.connect("source-read", title_links)
    app.connect("autodoc-process-docstring", link_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
