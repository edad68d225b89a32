"""Sentences and the blocks of a result on standard output."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

from rich.cells import cell_len
from rich.console import Console

from pkmodes.core.base.errors import printable
from pkmodes.plots.labels import RAISED, TIMES
from pkmodes.report.blocks import Cell, Facts, Lines, Listing, Paragraph, Summary, Table

#: Sentences are never wrapped to lines shorter than this.
NARROWEST = 40
#: Spaces between two columns, and between those of a table that fits the terminal only with them.
GAP, NARROW_GAP = 2, 1
#: Characters in a line where nobody says how many there are.
UNKNOWN = 80
#: First columns wider than this share of the terminal stand on a line above their row, where a table is too wide.
WIDE = 0.3
#: What our own titles and sentences have on a page, and how it is typed.
TYPED = {
    "chi\u00b2": "chi2",
    "\u00b2": "^2",
    "\u00b3": "^3",
    "\u00b7": "*",
    "\u00b5": "u",
    "\u00b0": "deg",
    "\u00b1": "+-",
    "\u03c3": "sigma",
    "\u2212": "-",
    "\u2013": "-",
    "\u2019": "'",
    "\u03c9": " omega ",
    "\u00a0": " ",
    "\u2009": ",",
}
SYMBOL = re.compile("|".join(TYPED))
#: A power of ten as in print, perhaps after the digits that it multiplies.
POWER = re.compile(f"({TIMES})?10([{''.join(map(chr, RAISED.values()))}]+)")
UPRIGHT = {raised: digit for digit, raised in RAISED.items()}


def typed(text: str) -> str:
    """Return a title or sentence of a page in characters that every terminal has."""
    powers = POWER.sub(lambda found: f"{'' if found[1] else '1'}e{found[2].translate(UPRIGHT)}", text)
    return SYMBOL.sub(lambda found: TYPED[found[0]], powers)


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

    def summary(self, summary: Summary) -> None:
        """Print the head of a result; `notes` ends it."""
        self.line(f"{summary.subject}: {typed(summary.headline)}")
        if summary.reason:
            self.line(typed(summary.reason), "  ")
        for name, cell in summary.facts:
            self.line(f"{typed(name)}: {typed(cell.typed)}", "  ")

    def notes(self, summary: Summary) -> None:
        """Print what the reader should know."""
        for note in summary.notes:
            self.line()
            self.line(f"note: {typed(note)}")

    def show(self, *blocks: Paragraph | Listing | Facts | Lines | Table) -> None:
        """Print blocks of a result as on its page, with an empty line before each but what a sentence announces."""
        announced = False
        for block in blocks:
            if not announced:
                self.line()
            announced = isinstance(block, Paragraph) and block.text.endswith(":")
            if isinstance(block, Table):
                self.table(block)
            elif isinstance(block, Paragraph):
                self.line(block.plain or typed(block.text))
            elif isinstance(block, Listing):
                for entry in [", ".join(block.entries)] if block.names else block.entries:
                    self.line(entry, "  ")
            elif isinstance(block, Facts):
                for name, cells in block.entries:
                    self.line(f"{typed(name)}: {' '.join(filter(None, map(_cell, cells)))}", "  ")
            else:
                self.line(f"{block.name}:")
                for entry in block.lines:
                    self.line(entry, "  ")

    def table(self, table: Table) -> None:
        """Print a table with its caption and its note.

        Where it is wider than the terminal, columns that do not fit go below, after those that tell the rows apart:
        about as many in each part, where that takes no further part.  A first column that would fill the terminal is
        broken at its commas, or stands on a line above its row.
        """
        kept = [k for k, column in enumerate(table.columns) if not column.page_only]
        over = [title for title, count in table.groups for _ in range(count)]
        titles = [typed(table.columns[k].title) for k in kept]
        groups = [typed(over[k]) if over else "" for k in kept]
        rows = [[_cell(row[k]) for k in kept] for row in table.rows]
        numbers = [table.columns[k].numbers for k in kept]
        begin = [c for c, k in enumerate(kept) if k < table.heads]
        if table.caption:
            self.line(typed(table.caption))
        names = [[row[0]] for row in rows]
        widths, gap, wide = self._measured(titles, rows, names)
        if wide:
            names = [name.replace(", ", ",\n").split("\n") for (name,) in names]
            widths, gap, wide = self._measured(titles, rows, names)
        if wide:
            names, begin = [[row[0]] for row in rows], begin[1:]
        for number, part in enumerate(self._parts(widths, begin, gap)):
            if number:
                self.line()
            if any(groups[c] for c in part):
                self._print(_over([groups[c] for c in part], [widths[c] + gap for c in part]))
            self._row(titles, part, widths, gap, numbers)
            before = ""
            for row, (name, *more) in zip(rows, names, strict=True):
                if 0 not in part:
                    if name != before:
                        self.line(name)
                    before = name
                self._row([name, *row[1:]], part, widths, gap, numbers)
                for rest in more if 0 in part else ():
                    self._print(rest)
        if table.note:
            self.line(typed(table.note))

    def _measured(
        self, titles: Sequence[str], rows: Sequence[Sequence[str]], names: Sequence[Sequence[str]]
    ) -> tuple[list[int], int, bool]:
        """Return widths of the columns, the spaces between them, and whether the names take too much of a line."""
        first = max(map(cell_len, (titles[0], *(part for name in names for part in name))))
        widths = [first, *(max(cell_len(row[c]) for row in (titles, *rows)) for c in range(1, len(titles)))]
        spaces, rest = len(widths) - 1, self._width - sum(widths)
        gap = NARROW_GAP if NARROW_GAP * spaces <= rest < GAP * spaces else GAP
        return widths, gap, gap * spaces > rest and first > WIDE * self._width

    def _row(
        self,
        row: Sequence[str],
        part: Sequence[int],
        widths: Sequence[int],
        gap: int,
        numbers: Sequence[bool],
    ) -> None:
        self._print((gap * " ").join(_aligned(row[c], widths[c], not numbers[c]) for c in part))

    def _print(self, text: str) -> None:
        self._console.print(text.rstrip(), soft_wrap=True)

    def _parts(self, widths: Sequence[int], begin: list[int], gap: int) -> list[list[int]]:
        """Return the columns of each part of a table, all of which begin with some; the first is theirs or none."""
        others = [c for c in range(1, len(widths)) if c not in begin]
        parts = self._filled(widths, begin, others, gap, len(widths))
        alike = self._filled(widths, begin, others, gap, -(-len(others) // len(parts)))
        return alike if len(alike) == len(parts) else parts

    def _filled(
        self, widths: Sequence[int], begin: list[int], others: Sequence[int], gap: int, most: int
    ) -> list[list[int]]:
        """Fill one part after the other with at most so many columns beside those with which it begins."""
        parts, added = [[*begin]], 0
        for k in others:
            width = sum(widths[i] + gap for i in parts[-1]) + widths[k]
            if added and (width > self._width or added == most):
                wide = sum(widths[i] + gap for i in begin) + widths[k] > self._width
                parts.append([*begin[: 1 if wide else None]])
                added = 0
            parts[-1].append(k)
            added += 1
        return parts


def _cell(cell: Cell) -> str:
    """Return the text of a cell; that of a file, such as a label, as it is there."""
    return printable(cell.typed if cell.value is None else typed(cell.typed))


def _over(groups: Sequence[str], widths: Sequence[int]) -> str:
    """Return the line above the titles: the title of a group begins above its first column."""
    line, place = "", 0
    for k, (group, width) in enumerate(zip(groups, widths, strict=True)):
        if group and (k == 0 or groups[k - 1] != group):
            line = f"{line.ljust(place)}{'' if len(line) < place or not line else ' '}{group}"
        place += width
    return line


def _aligned(text: str, width: int, left: bool) -> str:
    """Return a cell of a table, as wide as its column."""
    space = (width - cell_len(text)) * " "
    return text + space if left else space + text
