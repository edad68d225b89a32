"""The numbers that a figure shows, read from the figure itself: one table, whatever is drawn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots.drawn_names import Names, Side, names_of
from pkmodes.plots.labels import visible
from pkmodes.plots.style import styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Columns that every table begins with; a part is a piece of a broken curve.
PANEL, SERIES, PART = "panel", "series", "part"
#: Significant digits of places that are computed from the edges of cells or bars: without their rounding.
PLACES = 12
#: Significant digits of a value that is shown as a colour, which shows three, and where there are more than so many.
DIGITS, MANY, FEWER = 7, 60_000, 5
#: Significant digits of the points of curves and marks, if there are more of them than so many; otherwise all.
LONG = ((20_000, 6), (2_000, 9))
#: First characters that make a spreadsheet take a text for a formula, in the widths of East Asian text, too.
FORMULA = tuple("=+-@\uff1d\uff0b\uff0d\uff20")
#: Characters for which a text is quoted, and whole numbers below which are written without a point.
QUOTED, LARGEST = ',;"', 1e15


@dataclass(frozen=True)
class Drawn:
    """A series of N points in a panel.

    Attributes
    ----------
    kind : str
        What it is, if it has no name.
    name : str
        As in the legend; empty without one.
    x, y : ndarray, shape (N,)
        NaN where a mark has no such place.
    part : ndarray, shape (N,), or None
        The piece of a broken curve, from 1.
    values : ndarray, shape (N,), or None
        What the colour says.
    artist : object
        Whose colours the values have.
    """

    kind: str
    name: str
    x: Array
    y: Array
    part: Array | None = None
    values: Array | None = None
    artist: Any = field(default=None, repr=False)


def drawn_data(figure: Figure) -> list[list[str]]:
    """Return what a figure shows as the columns of a table: a row for each point, a column for each labelled axis.

    Curves, marks, error bars, bands, bars, and the cells of maps are in it; frames, grids, text, contours and
    drawings in three dimensions are not.

    Returns
    -------
    list of list of str
        Each column with its title, as the cells of a CSV file: ``panel`` and ``series``, and those that the labels of
        axes and colour scales name, with their units.  Where an axis has names instead of numbers, a further column
        has them.  Coordinates of curves and marks have all digits, or nine where there are thousands, and values
        shown as colours seven; where there are tens of thousands, six and five.  Text never begins as a formula of a
        spreadsheet does.  Empty if nothing is drawn.
    """
    with styled():  # labels of ticks are made here, and would otherwise read a name as a formula
        return _columns_of(figure)


def _columns_of(figure: Figure) -> list[list[str]]:
    tables: list[tuple[int, dict[str, list[Any]]]] = []
    names = names_of(figure)
    found = [(axes, drawn) for axes in names.panels for drawn in _series(axes, names)]
    coloured = sum(len(drawn.values) for _, drawn in found if drawn.values is not None)
    free = sum(len(drawn.x) for _, drawn in found if drawn.values is None)
    long = next((digits for count, digits in LONG if free > count), None)
    digits = (long, DIGITS if coloured <= MANY else FEWER)
    counts: dict[tuple[Any, str], int] = {}
    for axes, drawn in found:
        number = counts[axes, drawn.kind] = counts.get((axes, drawn.kind), 0) + 1
        title = drawn.name or f"{drawn.kind} {number}"
        tables.append(_columns(axes, drawn, title, names, digits))
    return _joined(tables)


def _series(axes: Axes, names: Names) -> Iterator[Drawn]:
    """Yield what a panel shows."""
    from matplotlib.collections import Collection
    from matplotlib.container import BarContainer, ErrorbarContainer
    from matplotlib.image import AxesImage
    from matplotlib.lines import Line2D

    taken: set[int] = set()
    for container in axes.containers:
        if isinstance(container, ErrorbarContainer):
            line, caps, bars = container.lines
            name = names.series(container) or names.series(line)
            taken |= {id(one) for one in (line, *caps, *bars) if one is not None}
            yield from _error_bars(name, line, bars)
        elif isinstance(container, BarContainer):
            taken |= {id(one) for one in container.patches}
            yield from _bars(names.series(container), container)
    for artist in axes.get_children():
        if id(artist) in taken or not artist.get_visible():
            continue
        if isinstance(artist, Line2D):
            yield from _line(axes, artist, names.series(artist))
        elif isinstance(artist, Collection):
            yield from _collection(axes, artist, names.series(artist))
        elif isinstance(artist, AxesImage):
            yield _image(artist, names.series(artist))


def _line(axes: Axes, line: Any, name: str) -> Iterator[Drawn]:
    x, y = (np.asarray(values, dtype=float) for values in line.get_data(orig=False))
    across, along = line.get_transform().contains_branch_seperately(axes.transData)
    if across and along:
        yield Drawn("curve" if line.get_linestyle() not in ("None", "none", "") else "marks", name, x, y)
    elif name and len(x):  # a line across the panel, at one place
        nothing = np.array([np.nan])
        yield Drawn("line", name, x[:1] if across else nothing, y[:1] if along else nothing)


def _error_bars(name: str, line: Any, bars: Sequence[Any]) -> Iterator[Drawn]:
    if line is not None:
        x, y = (np.asarray(values, dtype=float) for values in line.get_data(orig=False))
        yield Drawn("marks", name, x, y)
    for bar in bars:
        ends = np.array([segment for segment in bar.get_segments() if len(segment) == 2]).reshape(-1, 2, 2)
        for k, end in enumerate(("lower", "upper")):
            yield Drawn(f"{end} end", f"{name}, {end} end" if name else "", ends[:, k, 0], ends[:, k, 1])


def _bars(name: str, container: Any) -> Iterator[Drawn]:
    boxes = np.array([one.get_bbox().get_points() for one in container.patches]).reshape(-1, 2, 2)
    upright = container.orientation != "horizontal"
    along, across = (1, 0) if upright else (0, 1)
    middle = _rounded(boxes[..., across].mean(axis=1), PLACES)
    ends: list[tuple[str, Array]] = [("", boxes[:, 1, along])]
    if boxes[:, 0, along].any():
        ends = [(", lower end", boxes[:, 0, along]), (", upper end", boxes[:, 1, along])]
    for end, values in ends:
        x, y = (middle, values) if upright else (values, middle)
        yield Drawn(f"bars{end}", f"{name}{end}" if name else "", x, y)


def _collection(axes: Axes, artist: Any, name: str) -> Iterator[Drawn]:
    from matplotlib.collections import LineCollection, PathCollection, PolyCollection, QuadMesh
    from matplotlib.contour import ContourSet
    from matplotlib.quiver import Barbs, Quiver

    if isinstance(artist, QuadMesh):
        corners = np.asarray(artist.get_coordinates(), dtype=float)
        middle = 0.25 * (corners[1:, 1:] + corners[1:, :-1] + corners[:-1, 1:] + corners[:-1, :-1])
        x, y = (_rounded(middle[..., i].ravel(), PLACES) for i in (0, 1))
        yield Drawn("cells", name, x, y, values=_values(artist), artist=artist)
    elif isinstance(artist, PolyCollection) and not isinstance(artist, Barbs | Quiver):
        yield from _band(artist, name)
    elif isinstance(artist, LineCollection) and not isinstance(artist, ContourSet):
        if artist.get_transform().contains_branch_seperately(axes.transData) != (True, True):
            return
        pieces = [np.asarray(piece, dtype=float) for piece in artist.get_segments()]
        if pieces:
            points = np.concatenate(pieces)
            part = np.repeat(np.arange(1, len(pieces) + 1), [len(piece) for piece in pieces])
            yield Drawn("lines", name, points[:, 0], points[:, 1], part)
    elif isinstance(artist, PathCollection):
        points = np.ma.filled(np.ma.asarray(artist.get_offsets(), dtype=float), np.nan)
        values = None if artist.get_array() is None else _values(artist)
        yield Drawn("marks", name, points[:, 0], points[:, 1], values=values, artist=artist)


def _band(artist: Any, name: str) -> Iterator[Drawn]:
    """Yield the lower and the upper limit of a band: of the points at each place the lowest and the highest."""
    level = 1 if getattr(artist, "t_direction", "x") == "x" else 0  # matplotlib 3.9 does not say it
    points = np.concatenate([path.vertices for path in artist.get_paths()] or [np.empty((0, 2))])
    at, index = np.unique(points[:, 1 - level], return_inverse=True)
    for end, limit, start in (("lower", np.minimum, np.inf), ("upper", np.maximum, -np.inf)):
        ends = np.full(len(at), start)
        limit.at(ends, np.ravel(index), points[:, level])
        x, y = (at, ends) if level == 1 else (ends, at)
        yield Drawn(f"band, {end} limit", f"{name}, {end} limit" if name else "", x, y)


def _image(artist: Any, name: str) -> Drawn:
    cells: Array = np.ma.filled(np.ma.asarray(artist.get_array(), dtype=float), np.nan)
    rows, columns = cells.shape[:2]
    left, right, bottom, top = artist.get_extent()
    if artist.origin == "upper":
        bottom, top = top, bottom
    x, y = np.meshgrid(
        left + (np.arange(columns) + 0.5) * (right - left) / columns,
        bottom + (np.arange(rows) + 0.5) * (top - bottom) / rows,
    )
    values = cells.reshape(rows * columns, -1)[:, 0]
    x, y = _rounded(x.ravel(), PLACES), _rounded(y.ravel(), PLACES)
    return Drawn("cells", name, x, y, values=values, artist=artist)


def _values(artist: Any) -> Array:
    return np.ma.filled(np.ma.asarray(artist.get_array(), dtype=float), np.nan).ravel()


def _rounded(values: Array, digits: int) -> Array:
    """Return values with some significant digits."""
    return np.array([float(f"{value:.{digits}g}") for value in values.tolist()])


def _columns(
    axes: Axes, drawn: Drawn, title: str, names: Names, digits: tuple[int | None, int]
) -> tuple[int, dict[str, list[Any]]]:
    """Return the number of points, and the columns by their titles.

    Parameters
    ----------
    digits : tuple of int or None
        Significant digits of coordinates, and of values shown as colours; None for all.
    """
    seen = np.isfinite(drawn.x) & np.isfinite(drawn.y)
    if not seen.any():  # a line across the panel
        seen = np.isfinite(drawn.x) | np.isfinite(drawn.y)
    if drawn.values is not None:
        seen &= np.isfinite(drawn.values)
    columns: dict[str, list[Any]] = {PANEL: [names.panel(axes)], SERIES: [title]}
    if drawn.part is not None:
        columns[PART] = drawn.part[seen].tolist()
    sides: tuple[tuple[Side, Array], ...] = (("x", drawn.x), ("y", drawn.y))
    for side, every in sides:
        chosen = every[seen]
        short = digits[0] is not None and drawn.values is None
        places = (_rounded(chosen, digits[0] or PLACES) if short else chosen).tolist()
        label, ticks = names.axis(axes, side)
        columns[label] = places
        if ticks:
            columns[f"{label} (name)"] = [_tick(ticks, place) for place in places]
    if drawn.values is not None:
        label, meaning = names.colours(drawn.artist)
        values = drawn.values[seen]
        columns[label] = _rounded(values, digits[1]).tolist()
        if meaning is not None:
            columns[f"{label} (name)"] = [meaning(value) for value in values.tolist()]
    count = int(seen.sum())
    columns[PANEL] *= count
    columns[SERIES] *= count
    return count, columns


def _tick(ticks: Mapping[float, str], place: float) -> str:
    """Return the name of the nearest tick; names are at whole numbers, and marks may be beside each other there."""
    nearest = min(ticks, key=lambda tick: abs(tick - place))
    return ticks[nearest] if abs(nearest - place) <= 0.5 else ""


def _joined(tables: Sequence[tuple[int, Mapping[str, Sequence[Any]]]]) -> list[list[str]]:
    """Return the columns of all series below each other."""
    tables = [(count, columns) for count, columns in tables if count]
    titles = dict.fromkeys(title for _, columns in tables for title in columns)
    order = [title for title in (PANEL, SERIES, PART) if title in titles]
    order += [title for title in titles if title not in order]
    joined = []
    for title in order:
        cells = [_cell(title)]
        for count, columns in tables:
            cells += map(_cell, columns[title]) if title in columns else [""] * count
        joined.append(cells)
    return joined


def _cell(value: Any) -> str:
    """Return the text of a cell: numbers so that they read back the same, and text that is not a formula."""
    if isinstance(value, float):
        if not np.isfinite(value):
            return ""
        return str(int(value)) if value.is_integer() and abs(value) < LARGEST else repr(value)
    if not isinstance(value, str):
        return str(value)
    text = visible(value).strip()
    text = f"'{text}" if text.startswith(FORMULA) else text
    return '"' + text.replace('"', '""') + '"' if any(mark in text for mark in QUOTED) else text
