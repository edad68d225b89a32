"""The parts of a report: sections of paragraphs, tables, figures and differences between files.

They hold text for a person and exact numbers for a script; the templates only place them.  Text is arbitrary: the
templates escape it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from pkmodes.diagnosis.verdict.verdicts import Colour
from pkmodes.plots.svg import inline, inline_narrow

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Cells with at most this number of characters are not broken into lines.
SHORT = 26
#: Height over width from which on a figure is tall.
TALL = 0.85
VIEW_BOX = re.compile(r'viewBox="\S+ \S+ (\S+) (\S+)"')
Tone = Colour


@dataclass(frozen=True)
class Cell:
    """A cell of a table, or a value in a list.

    Attributes
    ----------
    text : str
        As shown.
    value : float or None
        The exact number, if it is one.
    at : str
        JSON pointer of that number in the output of ``--json``; empty if it is not in it.
    strong : bool
        Whether it is emphasised.
    """

    text: str
    value: float | None = None
    at: str = ""
    strong: bool = False

    @property
    def short(self) -> bool:
        """Whether it is short enough for one line on a small screen."""
        return len(self.text) <= SHORT


@dataclass(frozen=True)
class Column:
    """A column of a table: its title with the unit, and whether it holds numbers."""

    title: str
    numbers: bool = True


class Placed:
    """What every block of a section has: the programs that it needs in the browser, files of ``browser/``.

    A program of several files names them in their order, joined by ``+``.
    """

    programs: ClassVar[Sequence[str]] = ()


@dataclass(frozen=True)
class Table(Placed):
    """A table; the first cell of each row names it.

    Attributes
    ----------
    groups : sequence of (str, int)
        Titles above several columns and how many; empty for none.
    note : str
        What the table leaves out.
    """

    caption: str
    columns: Sequence[Column]
    rows: Sequence[Sequence[Cell]]
    groups: Sequence[tuple[str, int]] = ()
    note: str = ""
    kind: str = "table"


@dataclass(frozen=True)
class Picture(Placed):
    """A figure as an SVG element, how to read it, and its name.

    Attributes
    ----------
    narrow : str
        The same laid out for narrow screens; empty if it does not fit one.
    """

    svg: str
    caption: str
    title: str = "Figure"
    narrow: str = ""
    kind: str = "picture"

    @property
    def tall(self) -> bool:
        """Whether it is nearly as high as wide: it needs more height on paper to be read."""
        box = VIEW_BOX.search(self.svg)
        return box is not None and float(box[2]) > TALL * float(box[1])

    @classmethod
    def of(
        cls, figure: Figure, title: str, description: str, caption: str, *, cropped: bool = False
    ) -> Picture:
        """Return a figure for a page.

        Parameters
        ----------
        title : str
            Its name.
        description : str
            What it shows, for those who do not see it.
        caption : str
            How to read it.
        cropped : bool
            As for `pkmodes.plots.svg.inline`.
        """
        wide = inline(figure, title, description, cropped=cropped)
        return cls(wide, caption, title, inline_narrow(figure, title, description))


@dataclass(frozen=True)
class Paragraph(Placed):
    """A sentence or more."""

    text: str
    kind: str = "paragraph"


@dataclass(frozen=True)
class Listing(Placed):
    """A list of sentences, or of names, which are set in columns."""

    entries: Sequence[str]
    names: bool = False
    kind: str = "listing"


@dataclass(frozen=True)
class Facts(Placed):
    """Names with values."""

    entries: Sequence[tuple[str, Sequence[Cell]]]
    kind: str = "facts"


@dataclass(frozen=True)
class Difference(Placed):
    """A unified difference of two texts, line by line."""

    name: str
    lines: Sequence[str]
    kind: str = "difference"

    @staticmethod
    def sort(line: str) -> str:
        """Return what a line does: ``added``, ``removed``, ``place`` or ``same``."""
        if line.startswith(("---", "+++", "@@")):
            return "place"
        return {"+": "added", "-": "removed"}.get(line[:1], "same")


@dataclass(frozen=True)
class Lines(Placed):
    """Lines to copy, as they stand."""

    name: str
    lines: Sequence[str]
    kind: str = "lines"


@dataclass(frozen=True)
class Foreign(Placed):
    """Finished HTML from another module of pkmodes, which is placed as it is: the view in three dimensions."""

    html: str
    kind: str = "foreign"


@dataclass(frozen=True)
class Slider:
    """A slider along an axis of a map: the number of the axis, its name and unit, and how many values it has."""

    axis: int
    name: str
    unit: str
    count: int


@dataclass(frozen=True)
class Explorer(Placed):
    """An interactive map.

    Attributes
    ----------
    data : str
        JSON for the program, safe inside a page.
    modes : sequence of int
        Numbers of the modes.
    sliders : sequence of Slider
        One for each axis with several values.
    planes : sequence of (str, str)
        Pairs of components over which it can be drawn, empty if there is no choice.
    note : str
        Which poses of the map the page holds.
    machine : bool
        Whether a view of the machine on the page follows.
    varied : bool
        Whether it is a map of several robots: of a sweep, or drawn.
    """

    data: str
    modes: Sequence[int]
    sliders: Sequence[Slider]
    planes: Sequence[tuple[str, str]]
    note: str
    machine: bool
    varied: bool
    programs = ("map_values+map_chart+map_picture+map_table+map_explorer",)
    kind: str = "explorer"


Block = Table | Picture | Paragraph | Listing | Facts | Difference | Lines | Foreign | Explorer


@dataclass(frozen=True)
class Section:
    """A section of a page.

    Attributes
    ----------
    name : str
        Its id: letters and hyphens.
    """

    name: str
    title: str
    blocks: Sequence[Block]


@dataclass(frozen=True)
class Summary:
    """The head of a page: what was found, before everything else.

    Attributes
    ----------
    subject : str
        What the page is about, such as the name of a robot.
    kind : str
        What was done, such as "Diagnosis".
    verdict : str
        The verdict as in the JSON; empty if there is none.
    facts : sequence of (str, Cell)
        The most important numbers.
    """

    subject: str
    kind: str
    verdict: str
    headline: str
    reason: str
    tone: Tone
    notes: Sequence[str] = ()
    facts: Sequence[tuple[str, Cell]] = ()
