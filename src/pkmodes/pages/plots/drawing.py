"""A figure as a function that draws it on a wide or a narrow sheet, with the table of its numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.labels import visible_text
from pkmodes.pages.plots.panel import Panel, Series, Side
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import figure_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Titles of the first columns of every table; a part is a piece of a broken curve.
PANEL_COLUMN, SERIES_COLUMN, PART_COLUMN = "panel", "series", "part"
#: Significant digits of the positions of cells, few enough to hide the rounding errors of unit conversion.
POSITION_DIGITS = 12
#: Significant digits of values shown as colours, of which the eye resolves three; then the number of values above
#: which fewer digits are written, and how many.
VALUE_DIGITS, MANY_VALUES, MANY_VALUES_DIGITS = 7, 60_000, 5
#: Numbers of points above which the coordinates of curves and marks are rounded, with the significant digits; fewer
#: points keep all digits.
POINT_DIGITS = ((20_000, 6), (2_000, 9))
#: First characters that make a spreadsheet read a text as a formula, including their East Asian full-width forms.
FORMULA_STARTS = tuple("=+-@\uff1d\uff0b\uff0d\uff20")
#: Characters for which a text is quoted; then the limit below which whole numbers have no decimal point.
QUOTED_CHARACTERS, MAX_WHOLE_NUMBER = ',;"', 1e15


@dataclass(frozen=True, eq=False)
class Drawing:
    """A figure.

    - draw: function that draws it on a `Sheet`
    - narrow: whether it can be drawn on a narrow sheet
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
        """The numbers that the figure shows: columns, each with its title, as the cells of a CSV file.

        There is a row for each point.  The columns are ``panel``, ``series``, and one for each axis and colour scale,
        titled by its label with the unit.  An axis with names instead of numbers has a further column for the names.
        Coordinates of curves and marks have all digits, or nine if there are thousands of points; values shown as
        colours have seven; with tens of thousands, six and five.  No text can be read by a spreadsheet as a formula.
        Empty if nothing is drawn.
        """
        panel_series = [(panel, series) for panel in self.wide.panels for series in panel.series]
        coloured_count = sum(len(series.x) for _, series in panel_series if series.values is not None)
        point_count = sum(len(series.x) for _, series in panel_series) - coloured_count
        coordinate_digits = next((digits for count, digits in POINT_DIGITS if point_count > count), None)
        value_digits = VALUE_DIGITS if coloured_count <= MANY_VALUES else MANY_VALUES_DIGITS
        tables = [_columns(panel, series, coordinate_digits, value_digits) for panel, series in panel_series]
        tables = [(count, columns) for count, columns in tables if count]
        titles = dict.fromkeys(title for _, columns in tables for title in columns)
        order = [title for title in (PANEL_COLUMN, SERIES_COLUMN, PART_COLUMN) if title in titles]
        order += [title for title in titles if title not in order]
        table_columns = []
        for title in order:  # the columns of all series below each other
            cells = [_cell_text(title)]
            for count, columns in tables:
                cells += map(_cell_text, columns[title]) if title in columns else [""] * count
            table_columns.append(cells)
        return table_columns

    def sheet(self, *, narrow: bool) -> Sheet:
        """Draw the figure on a new sheet."""
        with figure_style():
            sheet = Sheet(narrow=narrow)
            self.draw(sheet)
        return sheet


def _columns(
    panel: Panel, series: Series, coordinate_digits: int | None, value_digits: int
) -> tuple[int, dict[str, list[Any]]]:
    """Return the number of points, and the columns by their titles.

    - coordinate_digits: significant digits of the coordinates of curves and marks, None for all
    - value_digits: significant digits of values shown as colours
    """
    is_drawn = np.isfinite(series.x) & np.isfinite(series.y)
    if not is_drawn.any():  # a line across the panel
        is_drawn = np.isfinite(series.x) | np.isfinite(series.y)
    if series.values is not None:
        is_drawn &= np.isfinite(series.values)
        coordinate_digits = POSITION_DIGITS
    count = int(is_drawn.sum())
    columns: dict[str, list[Any]] = {
        PANEL_COLUMN: [panel.title] * count,
        SERIES_COLUMN: [series.name] * count,
    }
    if series.part is not None:
        columns[PART_COLUMN] = series.part[is_drawn].tolist()
    sides: tuple[tuple[Side, Array], ...] = (("x", series.x), ("y", series.y))
    for side, coordinates in sides:
        title, names = visible_text(panel.labels[side]) or side, panel.tick_names[side]
        drawn_coordinates = coordinates[is_drawn]
        if panel.labels["x"] == panel.labels["y"] != "":
            title = f"{side}: {title}"
        columns[title] = (
            drawn_coordinates.tolist()
            if coordinate_digits is None
            else _rounded_values(drawn_coordinates, coordinate_digits)
        )
        has_names = any(name != f"{position:g}" for position, name in names.items())  # not just the numbers
        if has_names:
            columns[f"{title} (name)"] = [
                _nearest_name(names, coordinate) for coordinate in drawn_coordinates.tolist()
            ]
    if series.values is not None:
        title, values = panel.labels["scale"] or "value", series.values[is_drawn]
        columns[title] = _rounded_values(values, value_digits)
        if series.value_names:
            columns[f"{title} (name)"] = [series.value_names[int(value)] for value in values.tolist()]
    return count, columns


def _nearest_name(names: Mapping[float, str], position: float) -> str:
    """Return the nearest name; names are at whole numbers, and marks next to one another around them."""
    nearest = min(names, key=lambda name_position: abs(name_position - position))
    return names[nearest] if abs(nearest - position) <= 0.5 else ""


def _rounded_values(values: Array, digits: int) -> list[float]:
    return [float(f"{value:.{digits}g}") for value in values.tolist()]


def _cell_text(value: Any) -> str:
    """Return the text of a cell: all digits of a number, and text that a spreadsheet does not read as a formula."""
    if isinstance(value, float):
        if not np.isfinite(value):
            return ""
        return str(int(value)) if value.is_integer() and abs(value) < MAX_WHOLE_NUMBER else repr(value)
    if not isinstance(value, str):
        return str(value)
    text = visible_text(value).strip()
    text = f"'{text}" if text.startswith(FORMULA_STARTS) else text
    is_quoted = any(character in text for character in QUOTED_CHARACTERS)
    return '"' + text.replace('"', '""') + '"' if is_quoted else text
