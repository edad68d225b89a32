"""Sentences and tables on standard output."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from rich.console import Console
from rich.table import Table

from pkmodes.base.errors import printable

#: Tables are as wide as their numbers need and are never truncated.
WIDEST_TABLE = 10_000
#: Sentences are never wrapped to lines shorter than this.
NARROWEST = 40


class Terminal:
    """Sentences and tables on standard output: sentences are wrapped at spaces, tables are never truncated.

    Text from files, such as labels, is shown verbatim, including brackets and colons; only characters that are not
    visible are written as escapes.
    """

    def __init__(self) -> None:
        self._console = Console(highlight=False, markup=False, emoji=False)
        self._width = max(self._console.width, NARROWEST)
        self._console.width = WIDEST_TABLE

    @property
    def width(self) -> int:
        """Characters in a line: 80 where standard output is no terminal."""
        return self._width

    def heading(self, text: str) -> None:
        """Print a line that may name a file; it is not wrapped, so that the name can be copied."""
        self._console.print(printable(text), soft_wrap=True)

    def line(self, text: str = "", indent: str = "") -> None:
        """Print a sentence; every line starts with `indent`."""
        for part in self.wrapped(text, indent) or [""]:
            self._console.print(part, soft_wrap=True)

    def wrapped(self, text: str, indent: str = "") -> list[str]:
        """Return the lines of a sentence."""
        return textwrap.wrap(
            printable(text),
            self._width,
            initial_indent=indent,
            subsequent_indent=indent,
            break_long_words=False,
            break_on_hyphens=False,
        )

    def table(self, titles: Sequence[str], rows: Sequence[Sequence[str]], left: Sequence[str] = ()) -> None:
        """Print a table; columns named in `left` hold text, the others numbers."""
        table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0))
        for title in titles:
            table.add_column(title, justify="left" if title in left else "right", no_wrap=True)
        for row in rows:
            table.add_row(*map(printable, row))
        self._console.print(table)
