"""What Sphinx takes from pages and docstrings: titles of pages for their file names, and useful signatures only."""

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


def hide_constructor(
    app: Sphinx, what: str, name: str, obj: object, options: object, signature: str, returns: str
) -> tuple[str, None] | None:
    """Leave out the arguments of classes that only pkmodes creates: their docstrings list no parameters."""
    created = what in ("class", "exception") and "\n    Parameters\n" not in (obj.__doc__ or "")
    return ("", None) if created else None


def setup(app: Sphinx) -> dict[str, bool]:
    """Register all."""
    app.connect("source-read", title_links)
    app.connect("autodoc-process-docstring", link_pages)
    app.connect("autodoc-process-signature", hide_constructor)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
