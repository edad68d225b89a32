"""The blocks of a result, as on its page, as lines of a terminal in characters that every terminal has.

Sentences are wrapped at spaces; the columns of a table that do not fit follow below.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from rich.cells import cell_len

from pkmodes.core.base.errors import printable
from pkmodes.pages.plots.labels import SUPERSCRIPTS, TIMES
from pkmodes.pages.report.blocks import Cell, Facts, Listing, Paragraph, Table, VerbatimLines

TerminalBlock = Paragraph | Listing | Facts | VerbatimLines | Table
INDENT = "  "
#: Spaces between two columns, and between those of a table that would not fit the terminal otherwise.
GAP, NARROW_GAP = 2, 1
#: Maximum share of the width for the first column of a table that does not fit.
MAX_FIRST_COLUMN_SHARE = 0.3
#: How characters of the titles and sentences of a page are written on a terminal.
TERMINAL_CHARACTERS = {
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
SYMBOL = re.compile("|".join(TERMINAL_CHARACTERS))
#: A power of ten as in print, with or without a factor.
POWER = re.compile(f"({TIMES})?10([{''.join(map(chr, SUPERSCRIPTS.values()))}]+)")
DIGIT_OF_SUPERSCRIPT = {raised: digit for digit, raised in SUPERSCRIPTS.items()}


def terminal_text(text: str) -> str:
    """Return a title or sentence of a page in characters that every terminal has."""
    powers = POWER.sub(
        lambda match: f"{'' if match[1] else '1'}e{match[2].translate(DIGIT_OF_SUPERSCRIPT)}", text
    )
    return SYMBOL.sub(lambda match: TERMINAL_CHARACTERS[match[0]], powers)


def wrap_sentence(text: str, width: int, indent: str = "") -> list[str]:
    """Return the lines of a sentence, each after `indent`."""
    return textwrap.wrap(
        printable(text),
        width,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )


def block_lines(block: TerminalBlock, width: int) -> Iterator[str]:
    """Yield the lines of a block."""
    if isinstance(block, Table):
        yield from wrap_sentence(terminal_text(block.caption), width)
        yield from _table_lines(block, width)
        yield from wrap_sentence(terminal_text(block.note), width)
    elif isinstance(block, Paragraph):
        yield from wrap_sentence(block.plain_text or terminal_text(block.text), width)
    elif isinstance(block, Listing):
        for entry in [", ".join(block.entries)] if block.in_columns else block.entries:
            yield from wrap_sentence(entry, width, INDENT)
    elif isinstance(block, Facts):
        for name, cells in block.entries:
            values = " ".join(filter(None, map(_cell_text, cells)))
            yield from wrap_sentence(f"{terminal_text(name)}: {values}", width, INDENT)
    else:
        yield printable(f"{block.name}:")
        yield from (printable(f"{INDENT}{line}") for line in block.lines)


def _cell_text(cell: Cell) -> str:
    """Return the text of a cell; text from a file, such as a label, is unchanged."""
    return printable(cell.terminal_text if cell.value is None else terminal_text(cell.terminal_text))


@dataclass(frozen=True)
class _TextTable:
    """The text of a table, column by column.

    - names: for each row the lines that are printed in place of its first cell
    - rows: all cells of each row
    - is_number: for each column whether it is aligned at the right
    - heads: number of first columns that identify a row
    """

    titles: Sequence[str]
    groups: Sequence[str]
    names: Sequence[Sequence[str]]
    rows: Sequence[Sequence[str]]
    is_number: Sequence[bool]
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
        spaces, spare = len(self.widths) - 1, self.width - sum(self.widths)
        return NARROW_GAP if NARROW_GAP * spaces <= spare < GAP * spaces else GAP

    @property
    def is_crowded(self) -> bool:
        """Whether the table does not fit, and its first column takes much of the width."""
        total_width = sum(self.widths) + self.gap * (len(self.widths) - 1)
        return total_width > self.width and self.widths[0] > MAX_FIRST_COLUMN_SHARE * self.width

    def format_row(self, cells: Sequence[str], columns: Sequence[int]) -> str:
        """Return some cells of a row, each as wide as its column."""
        aligned = []
        for c in columns:
            padding = (self.widths[c] - cell_len(cells[c])) * " "
            aligned.append(padding + cells[c] if self.is_number[c] else cells[c] + padding)
        return (self.gap * " ").join(aligned).rstrip()

    def group_line(self, columns: Sequence[int]) -> str:
        """Return the line of group titles above some columns; each begins above the first column of its group."""
        line, position, previous = "", 0, ""
        for c in columns:
            if self.groups[c] and self.groups[c] != previous:
                line = (
                    f"{line.ljust(position)}{' ' if line and len(line) >= position else ''}{self.groups[c]}"
                )
            previous = self.groups[c]
            position += self.widths[c] + self.gap
        return line

    def parts(self, head_columns: list[int]) -> list[list[int]]:
        """Divide the columns into parts that fit: each begins with the head columns and has about as many others."""
        other_columns = [c for c in range(1, len(self.widths)) if c not in head_columns]
        parts = self._fill_parts(head_columns, other_columns, len(other_columns))
        balanced = self._fill_parts(head_columns, other_columns, -(-len(other_columns) // len(parts)))
        return balanced if len(balanced) == len(parts) else parts

    def _fill_parts(
        self, head_columns: list[int], other_columns: Sequence[int], limit: int
    ) -> list[list[int]]:
        """Fill one part after the other with at most `limit` columns after the head columns."""
        parts, added_count = [[*head_columns]], 0
        for c in other_columns:
            if added_count and (added_count == limit or not self._fits([*parts[-1], c])):
                # A very wide column has only the first head column beside it.
                parts.append([*(head_columns if self._fits([*head_columns, c]) else head_columns[:1])])
                added_count = 0
            parts[-1].append(c)
            added_count += 1
        return parts

    def _fits(self, columns: Sequence[int]) -> bool:
        return sum(self.widths[c] for c in columns) + self.gap * (len(columns) - 1) <= self.width


def _table_lines(table: Table, width: int) -> Iterator[str]:
    """Yield the lines of a table.

    Columns that do not fit follow below, each time after the head columns.  A first column that takes too much of the
    width is broken at its commas; if that is not enough, its cells are on lines of their own above the rows.
    """
    printed_columns = [k for k, column in enumerate(table.columns) if not column.page_only]
    group_titles = [title for title, count in table.groups for _ in range(count)]
    rows = [[_cell_text(row[k]) for k in printed_columns] for row in table.rows]
    columns = [table.columns[k] for k in printed_columns]
    text_table = _TextTable(
        titles=[terminal_text(column.title) for column in columns],
        groups=[terminal_text(group_titles[k]) if group_titles else "" for k in printed_columns],
        names=[[row[0]] for row in rows],
        rows=rows,
        is_number=[column.numeric for column in columns],
        heads=sum(k < table.key_columns for k in printed_columns),
        width=width,
    )
    if text_table.is_crowded:
        text_table = replace(text_table, names=[row[0].replace(", ", ",\n").split("\n") for row in rows])
    names_above = text_table.is_crowded
    for number, part_columns in enumerate(text_table.parts([*range(int(names_above), text_table.heads)])):
        if number:
            yield ""
        if any(text_table.groups[c] for c in part_columns):
            yield text_table.group_line(part_columns)
        yield text_table.format_row(text_table.titles, part_columns)
        previous_name = ""
        for row, (name, *continuation) in zip(rows, text_table.names, strict=True):
            if names_above:
                if row[0] != previous_name:
                    yield from wrap_sentence(row[0], width)
                previous_name = row[0]
                yield text_table.format_row(row, part_columns)
            else:
                yield text_table.format_row([name, *row[1:]], part_columns)
                yield from continuation
