"""A figure as a function that draws it: what it shows on a wide and on a narrow sheet, and the numbers of both."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from pkmodes.plots.sheet import Sheet
from pkmodes.plots.style import styled
from pkmodes.plots.table import table_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False)
class Drawing:
    """A figure.

    Attributes
    ----------
    draw : function
        Draws it on a `Sheet`.
    narrow : bool
        Whether it can be drawn on a narrow one.
    """

    draw: Callable[[Sheet], None]
    narrow: bool = True

    @cached_property
    def wide(self) -> Sheet:
        """The figure as wide as a page's text."""
        return self.sheet(narrow=False)

    @property
    def figure(self) -> Figure:
        """The wide figure of matplotlib."""
        return self.wide.figure

    @property
    def table(self) -> list[list[str]]:
        """The numbers that it shows: columns, each with its title, as the cells of a CSV file."""
        return table_of(self.wide.panels)

    def sheet(self, *, narrow: bool) -> Sheet:
        """Draw it, in the style of all figures."""
        with styled():
            sheet = Sheet(narrow=narrow)
            self.draw(sheet)
        return sheet
