"""The parts of a report: sections of paragraphs, tables, figures and differences between files.

They hold text for a person and exact numbers for a script; the templates only place them, on a page, and
`pkmodes.cli.layout` on a terminal.  Text is arbitrary: the templates escape it.
"""

from __future__ import annotations

import re
import zlib
from base64 import b64encode
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from pkmodes.pages.plots.svg import inline_narrow_svg, inline_svg

if TYPE_CHECKING:
    from pkmodes.loop.diagnosis.verdict.verdicts import Colour
    from pkmodes.pages.plots.drawing import Drawing

#: Cells of up to this many characters are not wrapped.
MAX_UNWRAPPED_LENGTH = 26
#: Ratio of height to width above which a figure counts as tall.
TALL_ASPECT_RATIO = 0.85
VIEW_BOX = re.compile(r'viewBox="\S+ \S+ (\S+) (\S+)"')


@dataclass(frozen=True)
class Spread:
    """The standard deviation of a value in the same cell: (1.92 ± 0.13) times a power of ten.

    - json_pointer: JSON pointer of it; empty if it is not in the JSON
    - value_digits, sigma_digits: those of the value and of the standard deviation
    - power_of_ten: what both are multiplied by; empty for nothing
    """

    sigma: float
    json_pointer: str
    value_digits: str
    sigma_digits: str
    power_of_ten: str


@dataclass(frozen=True)
class Cell:
    """A cell of a table, or a value in a list.

    - text: as shown on a page
    - value: the exact number, if it is one
    - json_pointer: JSON pointer of that number in the output of ``--json``; empty if it is not in it
    - strong: whether it is emphasised
    - spread: the standard deviation that its text contains
    - identifier: of what the text describes, shown below it, and on a terminal instead of it; empty for none
    - plain_text: the text on a terminal: a number or a unit as it can be typed, a label in full; empty where `text`
      is that
    """

    text: str
    value: float | None = None
    json_pointer: str = ""
    strong: bool = False
    spread: Spread | None = None
    identifier: str = ""
    plain_text: str = ""

    @classmethod
    def named(cls, words: str, name: str) -> Cell:
        """Return words with the identifier of what they mean, or the identifier alone where there are none."""
        return cls(words, identifier=name) if words and words != name else cls(name)

    @property
    def fits_one_line(self) -> bool:
        """Whether it is short enough for one line on a small screen."""
        return len(self.text) <= MAX_UNWRAPPED_LENGTH

    @property
    def terminal_text(self) -> str:
        """As shown on a terminal."""
        return self.plain_text or self.identifier or self.text


@dataclass(frozen=True)
class Column:
    """A column of a table: its title with the unit, whether it holds numbers, and whether only a page has it."""

    title: str
    numeric: bool = True
    page_only: bool = False


class TemplateBlock:
    """Base of the blocks of a section.

    - programs: programs that the block needs in the browser, files of ``browser/``.  A program of several files names
      them in their order, joined by ``+``.
    """

    programs: ClassVar[Sequence[str]] = ()

    @property
    def kind(self) -> str:
        """Name of the block in the templates."""
        return type(self).__name__.lower()


@dataclass(frozen=True)
class Table(TemplateBlock):
    """A table; the first cell of each row names it.

    - groups: titles above several columns and how many; empty for none
    - note: what the table leaves out
    - key_columns: first columns, which identify the rows: a terminal repeats them where the others do not fit side by
      side
    """

    caption: str
    columns: Sequence[Column]
    rows: Sequence[Sequence[Cell]]
    groups: Sequence[tuple[str, int]] = ()
    note: str = ""
    key_columns: int = 1


@dataclass(frozen=True)
class Picture(TemplateBlock):
    """A figure as an SVG element, how to read it, its name, and the numbers that it shows.

    - packed_table: the numbers, the columns of its table one after the other, deflated (RFC 1950) and in base 64;
      empty if there are none
    - narrow_svg: the same laid out for narrow screens; empty if it does not fit one
    """

    svg: str
    caption: str
    title: str = "Figure"
    packed_table: str = ""
    narrow_svg: str = ""
    programs: ClassVar[Sequence[str]] = ("download",)

    @property
    def is_tall(self) -> bool:
        """Whether it is nearly as tall as wide, and so needs more height on paper."""
        box = VIEW_BOX.search(self.svg)
        return box is not None and float(box[2]) > TALL_ASPECT_RATIO * float(box[1])

    @classmethod
    def from_drawing(
        cls, drawing: Drawing, title: str, description: str, caption: str, *, cropped: bool = False
    ) -> Picture:
        """Return a figure for a page, which can be saved from there as PNG, and its numbers as CSV.

        - title: its name
        - description: what it shows, for those who do not see it
        - caption: how to read it
        - cropped: as for `pkmodes.pages.plots.svg.inline_svg`
        """
        wide = inline_svg(drawing.figure, title, description, cropped=cropped)
        return cls(
            wide, caption, title, _pack_table(drawing.table), inline_narrow_svg(drawing, title, description)
        )


def _pack_table(columns: Sequence[Sequence[str]]) -> str:
    """Return a packed table, of which the page's program makes a file: a line per cell, a blank one between columns.

    Columns compress to half the size of rows.
    """
    text = "\n\n".join("\n".join(cell or " " for cell in column) for column in columns)
    return b64encode(zlib.compress(text.encode("utf-8", errors="replace"), 9)).decode("ascii") if text else ""


@dataclass(frozen=True)
class Paragraph(TemplateBlock):
    """A sentence or more; `plain_text` as on a terminal, where it names something of a file, such as a label."""

    text: str
    plain_text: str = ""


@dataclass(frozen=True)
class Listing(TemplateBlock):
    """A list of sentences, or of names, which are set in columns."""

    entries: Sequence[str]
    in_columns: bool = False


@dataclass(frozen=True)
class Facts(TemplateBlock):
    """Names with values."""

    entries: Sequence[tuple[str, Sequence[Cell]]]


@dataclass(frozen=True)
class TextDifference(TemplateBlock):
    """A unified difference of two texts, line by line."""

    name: str
    lines: Sequence[str]

    @staticmethod
    def line_kind(line: str) -> str:
        """Return the CSS class of a line: ``added``, ``removed``, ``place`` or ``same``."""
        if line.startswith(("---", "+++", "@@")):
            return "place"
        return {"+": "added", "-": "removed"}.get(line[:1], "same")


@dataclass(frozen=True)
class VerbatimLines(TemplateBlock):
    """Lines to copy verbatim."""

    name: str
    lines: Sequence[str]


@dataclass(frozen=True)
class EmbeddedHtml(TemplateBlock):
    """Finished HTML from another module of pkmodes, inserted as it is: the view in three dimensions."""

    html: str


@dataclass(frozen=True)
class Slider:
    """A slider along an axis of a map: the number of the axis, its name and unit, and how many values it has."""

    axis: int
    name: str
    unit: str
    count: int


@dataclass(frozen=True)
class Explorer(TemplateBlock):
    """An interactive map.

    - data: JSON for the program, safe inside a page
    - modes: numbers of the modes
    - sliders: one for each axis with several values
    - planes: pairs of components over which it can be drawn, empty if there is no choice
    - note: which poses of the map the page holds
    - has_machine_view: whether a view of the machine on the page follows
    - has_several_robots: whether it is a map of several robots: of a sweep, or drawn
    """

    data: str
    modes: Sequence[int]
    sliders: Sequence[Slider]
    planes: Sequence[tuple[str, str]]
    note: str
    has_machine_view: bool
    has_several_robots: bool
    programs = ("map_values+map_chart+map_picture+map_table+map_explorer",)


Block = (
    Table | Picture | Paragraph | Listing | Facts | TextDifference | VerbatimLines | EmbeddedHtml | Explorer
)


@dataclass(frozen=True)
class Section:
    """A section of a page.

    - html_id: its id: letters and hyphens
    - folded: whether a reader unfolds it, by a click or by going to it; on paper it is unfolded
    """

    html_id: str
    title: str
    blocks: Sequence[Block]
    folded: bool = False


@dataclass(frozen=True)
class Summary:
    """The head of a page: what was found, before everything else.

    - subject: what the page is about, such as the name of a robot
    - kind: what was done, such as "Diagnosis"
    - verdict: the verdict as in the JSON; empty if there is none
    - headline, reason: what was found, and why or where
    - action: what to do about it, in a box
    - facts: the most important numbers
    - head: titles and texts beside the subject, such as the customer: `pkmodes.core.robot.report_fields.head_of`
    """

    subject: str
    kind: str
    verdict: str = ""
    headline: str = ""
    reason: str = ""
    tone: Colour = "plain"
    notes: Sequence[str] = ()
    action: Facts | None = None
    facts: Sequence[tuple[str, Cell]] = ()
    head: Sequence[tuple[str, str]] = ()
