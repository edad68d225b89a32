"""Sentences and tables on standard output."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from rich.cells import cell_len
from rich.console import Console

from pkmodes.core.base.errors import printable

#: Sentences are never wrapped to lines shorter than this.
NARROWEST = 40
#: Characters in a line where nobody says how many there are.
UNKNOWN = 80


class Terminal:
    """Sentences and tables on standard output: sentences are wrapped at spaces, tables are never truncated.

    Text from files, such as labels, is shown verbatim, including brackets and colons; only characters that are not
    visible are written as escapes.
    """

    def __init__(self) -> None:
        # COLUMNS=0 says that the width is not known; on a console of that width Rich prints nothing at all.
        self._width = max(Console().width or UNKNOWN, NARROWEST)
        self._console = Console(highlight=False, markup=False, emoji=False, width=self._width)

    @property
    def width(self) -> int:
        """Characters in a line: 80 where standard output is not a terminal."""
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

    def table(
        self,
        titles: Sequence[str],
        rows: Sequence[Sequence[str]],
        left: Sequence[str] = (),
        *,
        gap: int = 2,
        repeated: int = 0,
        described_by: int = 0,
        even: bool = False,
        above: Sequence[str] = (),
    ) -> None:
        """Print a table.

        Parameters
        ----------
        titles : sequence of str
            Of the columns.
        rows : sequence of sequence of str
            Their cells.
        left : sequence of str
            Titles of the columns that hold text, the others hold numbers.
        gap : int
            Spaces between two columns.
        repeated : int
            Where the table is wider than the terminal, columns that do not fit go below, after this number of its
            first columns once more; 0 keeps it in one piece.
        described_by : int
            Columns that describe a row, all of which are in the first part; by default those that are repeated.
        even : bool
            Whether all parts have about the same number of columns, where that takes no further part.
        above : sequence of str
            A line above each row, if any; empty for none.
        """
        cells = [[printable(cell) for cell in row] for row in (titles, *rows)]
        widths = [max(cell_len(row[k]) for row in cells) for k in range(len(titles))]
        parts = [list(range(len(titles)))]
        if repeated:
            parts = self._parts(widths, gap, repeated, max(described_by, repeated), even)
        for number, part in enumerate(parts):
            if number:
                self.line()
            for i, row in enumerate(cells):
                if i and above and above[i - 1]:
                    self.line(above[i - 1])
                padded = [_aligned(row[k], widths[k], titles[k] in left) for k in part]
                self._console.print((gap * " ").join(padded).rstrip(), soft_wrap=True)

    def fits(self, titles: Sequence[str], rows: Sequence[Sequence[str]], gap: int = 2) -> bool:
        """Return whether a table is not wider than the terminal."""
        widths = [max(cell_len(printable(row[k])) for row in (titles, *rows)) for k in range(len(titles))]
        return sum(widths) + gap * (len(widths) - 1) <= self._width

    def _parts(
        self, widths: Sequence[int], gap: int, repeated: int, described_by: int, even: bool
    ) -> list[list[int]]:
        """Return the columns of each part of a table, every part as wide as the terminal at most."""
        count = len(widths) - described_by
        parts = self._filled(widths, gap, repeated, described_by, count)
        if not even:
            return parts
        alike = self._filled(widths, gap, repeated, described_by, -(-count // len(parts)))
        return alike if len(alike) == len(parts) else parts

    def _filled(
        self, widths: Sequence[int], gap: int, repeated: int, described_by: int, most: int
    ) -> list[list[int]]:
        """Fill one part after the other with at most so many columns beside those that describe a row."""
        parts = [list(range(described_by))]
        added = 0
        for k in range(described_by, len(widths)):
            width = sum(widths[i] for i in parts[-1]) + gap * len(parts[-1]) + widths[k]
            if added and (width > self._width or added == most):
                parts.append(list(range(repeated)))
                added = 0
            parts[-1].append(k)
            added += 1
        return parts


def _aligned(text: str, width: int, left: bool) -> str:
    """Return a cell of a table, as wide as its column."""
    space = (width - cell_len(text)) * " "
    return text + space if left else space + text
