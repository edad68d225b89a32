"""The blocks of a result as lines of a terminal: those of its page, in characters that every terminal has.

Sentences are wrapped at spaces; a table is never cut, but goes on below.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from rich.cells import cell_len

from pkmodes.core.base.errors import printable
from pkmodes.pages.plots.labels import RAISED, TIMES
from pkmodes.pages.report.blocks import Cell, Facts, Lines, Listing, Paragraph, Table

Shown = Paragraph | Listing | Facts | Lines | Table
INDENT = "  "
#: Spaces between two columns, and where a table fits the terminal only with fewer.
GAP, NARROW_GAP = 2, 1
#: Largest share of the width that the first column of a table takes where the table does not fit.
WIDE = 0.3
#: Characters that our own titles and sentences have on a page, and how they are typed on a terminal.
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
    "\u202f": ",",
    "\u2009": ",",
}
SYMBOL = re.compile("|".join(TYPED))
#: A power of ten as in print, perhaps after the digits that it multiplies.
POWER = re.compile(f"({TIMES})?10([{''.join(map(chr, RAISED.values()))}]+)")
UPRIGHT = {raised: digit for digit, raised in RAISED.items()}


def typed(text: str) -> str:
    """Return a title or sentence of a page in characters that every terminal has."""
    powers = POWER.sub(lambda match: f"{'' if match[1] else '1'}e{match[2].translate(UPRIGHT)}", text)
    return SYMBOL.sub(lambda match: TYPED[match[0]], powers)


def wrapped(text: str, width: int, indent: str = "") -> list[str]:
    """Return the lines of a sentence, each after `indent`."""
    return textwrap.wrap(
        printable(text),
        width,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )


def lines_of(block: Shown, width: int) -> Iterator[str]:
    """Yield the lines of a block."""
    if isinstance(block, Table):
        yield from wrapped(typed(block.caption), width)
        yield from _table(block, width)
        yield from wrapped(typed(block.note), width)
    elif isinstance(block, Paragraph):
        yield from wrapped(block.plain or typed(block.text), width)
    elif isinstance(block, Listing):
        for entry in [", ".join(block.entries)] if block.names else block.entries:
            yield from wrapped(entry, width, INDENT)
    elif isinstance(block, Facts):
        for name, cells in block.entries:
            values = " ".join(filter(None, map(_text, cells)))
            yield from wrapped(f"{typed(name)}: {values}", width, INDENT)
    else:
        yield printable(f"{block.name}:")
        yield from (printable(f"{INDENT}{line}") for line in block.lines)


def _text(cell: Cell) -> str:
    """Return the text of a cell; that of a file, such as a label, as it is there."""
    return printable(cell.typed if cell.value is None else typed(cell.typed))


@dataclass(frozen=True)
class _Grid:
    """The text of a table, column by column.

    - names: the lines of the first cell of each row
    - rows: all cells of each row; the first one is not printed, but its `names`
    - numbers: columns that are aligned at the right
    - heads: first columns that tell the rows apart
    """

    titles: Sequence[str]
    groups: Sequence[str]
    names: Sequence[Sequence[str]]
    rows: Sequence[Sequence[str]]
    numbers: Sequence[bool]
    heads: int
    width: int

    @cached_property
    def widths(self) -> list[int]:
        """Characters of each column."""
        first = max(map(cell_len, (self.titles[0], *(line for name in self.names for line in name))))
        later_columns = range(1, len(self.titles))
        return [first, *(max(cell_len(row[c]) for row in (self.titles, *self.rows)) for c in later_columns)]

    @property
    def gap(self) -> int:
        """Spaces between two columns."""
        spaces, rest = len(self.widths) - 1, self.width - sum(self.widths)
        return NARROW_GAP if NARROW_GAP * spaces <= rest < GAP * spaces else GAP

    @property
    def crowded(self) -> bool:
        """Whether the table does not fit, and its first column takes much of the width."""
        whole = sum(self.widths) + self.gap * (len(self.widths) - 1)
        return whole > self.width and self.widths[0] > WIDE * self.width

    def printed(self, cells: Sequence[str], part: Sequence[int]) -> str:
        """Return some cells of a row, each as wide as its column."""
        aligned = []
        for c in part:
            space = (self.widths[c] - cell_len(cells[c])) * " "
            aligned.append(space + cells[c] if self.numbers[c] else cells[c] + space)
        return (self.gap * " ").join(aligned).rstrip()

    def over(self, part: Sequence[int]) -> str:
        """Return the line above some titles: that of a group begins above its first column."""
        line, place, before = "", 0, ""
        for c in part:
            if self.groups[c] and self.groups[c] != before:
                line = f"{line.ljust(place)}{' ' if line and len(line) >= place else ''}{self.groups[c]}"
            before = self.groups[c]
            place += self.widths[c] + self.gap
        return line

    def parts(self, begin: list[int]) -> list[list[int]]:
        """Return the columns of each part: some with which all begin, and about as many of the others in each."""
        remaining = [c for c in range(1, len(self.widths)) if c not in begin]
        parts = self._filled(begin, remaining, len(remaining))
        alike = self._filled(begin, remaining, -(-len(remaining) // len(parts)))
        return alike if len(alike) == len(parts) else parts

    def _filled(self, begin: list[int], remaining: Sequence[int], limit: int) -> list[list[int]]:
        """Fill one part after the other with at most `limit` columns beside those with which it begins."""
        parts, added = [[*begin]], 0
        for c in remaining:
            if added and (added == limit or not self._fits([*parts[-1], c])):
                # A very wide column has only the first one beside it.
                parts.append([*(begin if self._fits([*begin, c]) else begin[:1])])
                added = 0
            parts[-1].append(c)
            added += 1
        return parts

    def _fits(self, part: Sequence[int]) -> bool:
        return sum(self.widths[c] for c in part) + self.gap * (len(part) - 1) <= self.width


def _table(table: Table, width: int) -> Iterator[str]:
    """Yield the lines of a table.

    Columns that do not fit go below, after those that tell the rows apart.  A first column that takes too much of the
    width is broken at its commas; if that is not enough, it stands on a line above its row.
    """
    kept = [k for k, column in enumerate(table.columns) if not column.page_only]
    over = [title for title, count in table.groups for _ in range(count)]
    rows = [[_text(row[k]) for k in kept] for row in table.rows]
    columns = [table.columns[k] for k in kept]
    grid = _Grid(
        titles=[typed(column.title) for column in columns],
        groups=[typed(over[k]) if over else "" for k in kept],
        names=[[row[0]] for row in rows],
        rows=rows,
        numbers=[column.numbers for column in columns],
        heads=sum(k < table.heads for k in kept),
        width=width,
    )
    if grid.crowded:
        grid = replace(grid, names=[row[0].replace(", ", ",\n").split("\n") for row in rows])
    above = grid.crowded
    for number, part in enumerate(grid.parts([*range(int(above), grid.heads)])):
        if number:
            yield ""
        if any(grid.groups[c] for c in part):
            yield grid.over(part)
        yield grid.printed(grid.titles, part)
        before = ""
        for row, (name, *continuation) in zip(rows, grid.names, strict=True):
            if above:
                if row[0] != before:
                    yield from wrapped(row[0], width)
                before = row[0]
                yield grid.printed(row, part)
            else:
                yield grid.printed([name, *row[1:]], part)
                yield from continuation
