"""A search for what the robot file defines leads there first: names in its tables are entries of the index."""

from __future__ import annotations

from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

#: Pages whose tables define names, in their first column.
PAGES = ("reference/robot-file",)


class IndexTables(SphinxTransform):
    """Add the names in the first column of every table of such a page to the index, each at its row."""

    default_priority = 840  # before Sphinx collects the entries of the index

    def apply(self, **_: Any) -> None:
        """Add them."""
        if self.env.docname not in PAGES:
            return
        for row in list(self.document.findall(nodes.row)):
            names = [literal.astext() for literal in row[0].findall(nodes.literal)]
            if names and isinstance(row.parent, nodes.tbody):
                anchor = f"defined-{nodes.make_id(names[0])}"
                entries = [("single", name, anchor, "main", None) for name in names]  # others come last
                row[0].insert(0, [addnodes.index(entries=entries), nodes.target("", "", ids=[anchor])])


def setup(app: Sphinx) -> dict[str, bool]:
    """Register it."""
    app.add_transform(IndexTables)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
