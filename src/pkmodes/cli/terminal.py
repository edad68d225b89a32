"""Sentences and the blocks of a result on standard output."""

from __future__ import annotations

from rich.console import Console

from pkmodes.cli.layout import INDENT, TerminalBlock, block_lines, terminal_text, wrap_sentence
from pkmodes.core.base.errors import printable
from pkmodes.pages.report.blocks import Facts, Paragraph, Summary

#: Minimum number of characters to which sentences are wrapped.
MIN_WIDTH = 40
#: Characters in a line where the width is unknown.
DEFAULT_WIDTH = 80


class Terminal:
    """Sentences and blocks on standard output.

    Text from files, such as labels, is shown verbatim, including brackets and colons; only characters that are not
    visible are written as escapes.
    """

    def __init__(self) -> None:
        # Rich assumes 80 where standard output is not a terminal.  COLUMNS=0 means that the width is unknown; on a
        # console of that width Rich prints nothing at all.
        self._width = max(Console().width or DEFAULT_WIDTH, MIN_WIDTH)
        self._console = Console(highlight=False, markup=False, emoji=False, width=self._width)

    def heading(self, text: str) -> None:
        """Print a line that may name a file; it is not wrapped, so that the name can be copied."""
        self._console.print(printable(text), soft_wrap=True)

    def line(self, text: str = "", indent: str = "") -> None:
        """Print a sentence; every line starts with `indent`."""
        for part in self.wrap(text, indent) or [""]:
            self._console.print(part, soft_wrap=True)

    def wrap(self, text: str, indent: str = "") -> list[str]:
        """Return the lines of a sentence."""
        return wrap_sentence(text, self._width, indent)

    def summary(self, summary: Summary) -> None:
        """Print the head of a result; `notes` ends it."""
        self.line(f"{summary.subject}: {terminal_text(summary.headline)}")
        if summary.reason:
            self.line(terminal_text(summary.reason), INDENT)
        self.block(Facts([(name, [cell]) for name, cell in summary.facts]))

    def notes(self, summary: Summary) -> None:
        """Print the notes of a result."""
        for note in summary.notes:
            self.line()
            self.line(f"note: {terminal_text(note)}")

    def result(self, head: Summary, *blocks: TerminalBlock) -> None:
        """Print a result: its head, blocks, and notes."""
        self.summary(head)
        self.show(*blocks)
        self.notes(head)

    def show(self, *blocks: TerminalBlock) -> None:
        """Print blocks as on the page of a result, each after an empty line except after a paragraph ending in :."""
        announced = False
        for block in blocks:
            if not announced:
                self.line()
            announced = isinstance(block, Paragraph) and block.text.endswith(":")
            self.block(block)

    def block(self, block: TerminalBlock) -> None:
        """Print a block."""
        for part in block_lines(block, self._width):
            self._console.print(part, soft_wrap=True)
