"""A panel of a figure: its curves and marks are kept as series of numbers, under the names in the figure."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from textwrap import fill
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.pages.plots.labels import visible_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.collections import PathCollection, QuadMesh
    from matplotlib.image import AxesImage

Array = NDArray[Any]
Side = Literal["x", "y"]
LabelKind = Literal["title", "x", "y"]
#: Characters per line of a title or label on a narrow sheet.
MAX_LINE_LENGTH = 44
#: Additional characters allowed per line of broken text, because lines break between words.
EXTRA_LINE_LENGTH = 5


@dataclass(frozen=True)
class Series:
    """N points in a panel.

    - name: as in the legend; without one, the kind of series and a number
    - x, y: in the units of the axes, (N,); NaN for a coordinate that a line across the panel does not have
    - part: the piece of a broken curve, from 1, (N,)
    - values: values shown by colour, (N,)
    - value_names: names of the values 0, 1, 2... if they are categories
    """

    name: str
    x: Array
    y: Array
    part: Array | None = None
    values: Array | None = None
    value_names: tuple[str, ...] = ()


class Panel:
    """Axes that keep the numbers drawn in them; frames, grids, shades and text are drawn on `axes` and not kept.

    Further keywords of its methods are for matplotlib; a ``label`` for the legend is also the name of the series.

    - narrow: whether the figure is for a narrow screen
    - left_panel: the panel at its left on a narrow sheet
    - omitted_labels: those of ``title``, ``x`` and ``y`` that a panel above, below or at the left has instead
    - title: on one line, with the name of the row of panels
    - labels: of the axes ``x`` and ``y``, of the ``row`` of panels, and of the colour ``scale``
    - tick_names: names of positions on the axes ``x`` and ``y`` that have names instead of numbers
    """

    def __init__(
        self,
        axes: Axes,
        *,
        narrow: bool = False,
        left_panel: Panel | None = None,
        omitted_labels: Iterable[LabelKind] = (),
    ) -> None:
        self.axes, self.narrow, self.left_panel = axes, narrow, left_panel
        self.omitted_labels: set[LabelKind] = set(omitted_labels)
        self.title = ""
        self.labels = {"x": "", "y": "", "row": "", "scale": ""}
        self.tick_names: dict[str, Mapping[float, str]] = {"x": {}, "y": {}}
        self.series: list[Series] = []
        self._counts: Counter[str] = Counter()

    def label(
        self,
        title: str = "",
        *,
        x: str = "",
        y: str = "",
        row: str = "",
        **settings: Any,
    ) -> None:
        """Set the title and the labels of the axes, without those in `omitted_labels`.

        - row: name of a row of panels, above the label of their vertical axes
        - settings: matplotlib settings of the title
        """
        self.title = ", ".join(" ".join(part.split("\n")) for part in (title, row) if part)
        self.labels |= {"x": x, "y": y, "row": row}
        omitted = self.omitted_labels
        if self.narrow:
            title, x, omitted = _wrapped(title), _wrapped(x), set()
            if self.left_panel is not None and (
                self.left_panel.labels["y"],
                self.left_panel.labels["row"],
            ) == (y, row):
                omitted = {"y"}
                self.axes.tick_params(labelleft=False)
        if "title" not in omitted:
            self.axes.set_title(title, **settings)
        if "x" not in omitted:
            self.axes.set_xlabel(x)
        if "y" not in omitted:
            self.axes.set_ylabel(f"{row}\n{y}" if row else y)

    def set_tick_names(
        self,
        side: Side,
        positions: Sequence[float],
        tick_labels: Sequence[str],
        table_names: Sequence[str] = (),
        **settings: Any,
    ) -> None:
        """Write names instead of numbers on an axis.

        - tick_labels: the names on the axis, possibly in several lines
        - table_names: the names in the table under the figure; by default the tick labels, each on one line
        - settings: matplotlib settings of the tick labels
        """
        set_ticks = self.axes.set_xticks if side == "x" else self.axes.set_yticks
        set_ticks(positions, tick_labels, **settings)
        names = table_names or [", ".join(name.split("\n")) for name in tick_labels]
        self.tick_names[side] = {
            float(position): name for position, name in zip(positions, names, strict=True)
        }

    def plot(
        self, x: ArrayLike, y: ArrayLike, line_format: str = "-", *, name: str = "", **style: Any
    ) -> None:
        """Draw a curve, or marks that all look the same.

        - line_format: as for `matplotlib.axes.Axes.plot`
        """
        self.axes.plot(np.asarray(x), np.asarray(y), line_format, **style)
        self._keep("curve" if set(line_format) & set("-:") else "marks", name or style.get("label"), x, y)

    def scatter(
        self, x: ArrayLike, y: ArrayLike, *, values: ArrayLike | None = None, name: str = "", **style: Any
    ) -> PathCollection:
        """Draw marks, in the colours of their values if there are any."""
        colours: dict[str, Any] = {} if values is None else {"c": values}
        collection = self.axes.scatter(x, y, **colours, **style)
        self._keep("marks", name or style.get("label"), x, y, values=values)
        return collection

    def error_bars(self, x: ArrayLike, y: ArrayLike, width: ArrayLike, **style: Any) -> None:
        """Draw marks with horizontal error bars.

        - width: length of the bar on either side
        """
        self.axes.errorbar(x, y, xerr=width, **style)
        name, centre, half_width = style["label"], np.asarray(x, float), np.asarray(width, float)
        self._keep("marks", name, x, y)
        self._keep("lower end", f"{name}, lower end", centre - half_width, y)
        self._keep("upper end", f"{name}, upper end", centre + half_width, y)

    def band(self, x: ArrayLike, low: ArrayLike, high: ArrayLike, *, name: str = "", **style: Any) -> None:
        """Shade the area between two curves."""
        self.axes.fill_between(x, low, high, **style)
        self.keep_band_limits(x, low, high, name)

    def keep_band_limits(self, x: ArrayLike, low: ArrayLike, high: ArrayLike, name: str = "") -> None:
        """Keep the limits of a band that is already drawn."""
        lower, upper = np.asarray(low, float), np.asarray(high, float)
        finite = np.isfinite(lower) & np.isfinite(upper)
        for end, limit in (("lower", lower), ("upper", upper)):
            kind = f"band, {end} limit"
            self._keep(kind, f"{name}, {end} limit" if name else "", x, np.where(finite, limit, np.nan))

    def bar(self, y: float, left: float, right: float, **style: Any) -> None:
        """Draw a horizontal bar; for a bar that does not begin at 0, both ends are kept."""
        self.axes.barh(y, right - left, left=left, **style)
        name = style["label"]
        if left == 0.0:
            self._keep("bars", name, right, y)
            return
        self._keep("bars, lower end", f"{name}, lower end", left, y)
        self._keep("bars, upper end", f"{name}, upper end", right, y)

    def lines(self, x: Array, y: Array, **style: Any) -> None:
        """Draw N straight lines between the points with the coordinates x (N, 2) and y (N, 2)."""
        from matplotlib.collections import LineCollection

        ends = np.stack(np.broadcast_arrays(x, y), axis=-1)
        self.axes.add_collection(LineCollection(list(ends), **style))
        self.axes.autoscale_view()
        part = np.repeat(np.arange(1, len(ends) + 1), 2)
        self._keep("lines", style.get("label"), ends[..., 0].ravel(), ends[..., 1].ravel(), part=part)

    def vertical_line(self, x: float, name: str, **style: Any) -> None:
        """Draw a vertical line across the panel."""
        self.axes.axvline(x, **style)
        self._keep("line", name, x, np.nan)

    def cells(
        self, x: Array, y: Array, values: Array, value_names: Sequence[str] = (), **style: Any
    ) -> QuadMesh:
        """Draw values (rows, columns) as coloured cells centred at x (columns,) and y (rows,); NaN stays blank.

        - value_names: names of the values 0, 1, 2... if they are categories
        """
        mesh = self.axes.pcolormesh(_cell_edges(x), _cell_edges(y), np.ma.masked_invalid(values), **style)
        self._keep_cells(x, y, values, tuple(value_names))
        return mesh

    def image(self, values: Array, **style: Any) -> AxesImage:
        """Draw values (rows, columns) as an image, its rows and columns counted from 0."""
        image = self.axes.imshow(values, **style)
        rows, columns = values.shape
        self._keep_cells(np.arange(columns), np.arange(rows), values)
        return image

    def _keep_cells(self, x: Array, y: Array, values: Array, value_names: tuple[str, ...] = ()) -> None:
        cell_x, cell_y = np.meshgrid(x, y)
        self._keep(
            "cells", "", cell_x.ravel(), cell_y.ravel(), values=values.ravel(), value_names=value_names
        )

    def _keep(
        self,
        kind: str,
        name: str | None,
        x: ArrayLike,
        y: ArrayLike,
        *,
        part: Array | None = None,
        values: ArrayLike | None = None,
        value_names: tuple[str, ...] = (),
    ) -> None:
        self._counts[kind] += 1
        title = visible_text(name) if name else f"{kind} {self._counts[kind]}"
        x_values, y_values = np.broadcast_arrays(
            np.atleast_1d(x).astype(float), np.atleast_1d(y).astype(float)
        )
        colour_values = None if values is None else np.asarray(values, dtype=float)
        self.series.append(Series(title, x_values, y_values, part, colour_values, value_names))


def _cell_edges(centres: Array) -> Array:
    """Return the edges of cells, halfway between their centres; a single cell has a width of 1."""
    half = 0.5 * np.diff(centres) if len(centres) > 1 else np.array([0.5])
    return np.concatenate(
        [centres[:1] - half[:1], centres[:-1] + half[: len(centres) - 1], centres[-1:] + half[-1:]]
    )


def _wrapped(text: str) -> str:
    """Return text in lines of about equal length that fit a narrow sheet."""
    return "\n".join(
        line
        if len(line) <= MAX_LINE_LENGTH
        else fill(line, len(line) // (len(line) // MAX_LINE_LENGTH + 1) + EXTRA_LINE_LENGTH)
        for line in text.split("\n")
    )
