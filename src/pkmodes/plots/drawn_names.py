"""How the panels, axes and series of a figure are called: by their own labels, or by those that they share."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from pkmodes.plots.labels import visible

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Side = Literal["x", "y"]
#: Colours that a reader does not tell apart, as numbers from 0 to 1.
SAME = 1e-3


@dataclass(frozen=True, eq=False)
class Names:
    """The names in a figure.

    Attributes
    ----------
    panels : tuple of Axes
        Those that show data in a plane, in the order of drawing.
    titles : mapping of Axes to str
        Of the panels.
    labels : mapping of (Axes, str) to str
        Of their axes.
    legend : tuple of (object, str)
        Handles of all legends with their labels.
    scales : mapping of object to str
        Labels of the colour scales, by what they belong to.
    """

    panels: tuple[Axes, ...]
    titles: Mapping[Axes, str]
    labels: Mapping[tuple[Axes, Side], str]
    legend: tuple[tuple[Any, str], ...]
    scales: Mapping[Any, str]

    def panel(self, axes: Axes) -> str:
        """Return the title of a panel."""
        return self.titles[axes]

    def axis(self, axes: Axes, side: Side) -> tuple[str, dict[float, str]]:
        """Return the label of an axis, and the names of its ticks where they are not numbers."""
        label, other = self.labels[axes, side], self.labels[axes, "y" if side == "x" else "x"]
        label = f"{side}: {label}" if label == other else label
        axis = axes.xaxis if side == "x" else axes.yaxis
        return label, _ticks(axis)

    def series(self, artist: Any) -> str:
        """Return the name of a series: its own, or that of the only entry of the legends that looks like it."""
        own = str(artist.get_label() or "")
        if own and not own.startswith("_"):
            return visible(own)
        look = _look(artist)
        alike = {label for handle, label in self.legend if look is not None and _look(handle) == look}
        return alike.pop() if len(alike) == 1 else ""

    def colours(self, artist: Any) -> tuple[str, Callable[[float], str] | None]:
        """Return what the colours of an artist mean, and the name of each if the legend gives them names."""
        from matplotlib.patches import Patch

        named = {
            _rgb(handle.get_facecolor()): label for handle, label in self.legend if isinstance(handle, Patch)
        }
        known = set(self.scales.values())
        label = self.scales.get(artist) or (known.pop() if len(known) == 1 else "value")
        if artist in self.scales or len(named) < 2:
            return label, None
        return label, lambda value: named.get(_rgb(artist.to_rgba(value)), "")


def names_of(figure: Figure) -> Names:
    """Return the names in a figure."""
    legends: list[Any] = figure.findobj(_is_legend)
    legend = tuple(
        (handle, visible(text.get_text()))
        for one in legends
        for handle, text in zip(one.legend_handles, one.texts, strict=True)
        if handle is not None
    )
    every = [axes for axes in figure.get_axes() if axes.get_visible() and axes.name == "rectilinear"]
    shown: list[Any] = figure.findobj(_has_scale)
    scales = {one: _line(one.colorbar.ax.get_ylabel() or one.colorbar.ax.get_xlabel()) for one in shown}
    bars = {id(one.colorbar.ax) for one in shown}
    panels = tuple(axes for axes in every if id(axes) not in bars)
    sides: tuple[Side, ...] = ("x", "y")
    labels = {(axes, side): _label(axes, side, panels) for axes in panels for side in sides}
    return Names(panels, _titles(panels), labels, legend, scales)


def _is_legend(artist: Any) -> bool:
    from matplotlib.legend import Legend

    return isinstance(artist, Legend)


def _has_scale(artist: Any) -> bool:
    return hasattr(getattr(artist, "colorbar", None), "mappable")


def _own(axes: Axes, side: Side) -> str:
    return str(axes.get_xlabel() if side == "x" else axes.get_ylabel())


def _label(axes: Axes, side: Side, panels: tuple[Axes, ...]) -> str:
    """Return the label of an axis; inner panels have that of the panel below or at the left, which is labelled.

    Lines above the last one of a label name a row of panels.
    """
    near = [axes, *(one for one in panels if one is not axes and _aligned(axes, one, side))]
    text = next((_own(one, side) for one in near if _own(one, side)), "")
    return visible(text.rpartition("\n")[2]) or side


def _aligned(one: Axes, other: Axes, side: Side) -> bool:
    """Return whether two panels are above each other (x) or beside each other (y) in one grid."""
    first, second = one.get_subplotspec(), other.get_subplotspec()
    if first is None or second is None or first.get_gridspec() is not second.get_gridspec():
        return False
    span = "colspan" if side == "x" else "rowspan"
    return bool(getattr(first, span) == getattr(second, span))


def _title(axes: Axes) -> str:
    return next((title for loc in ("left", "center", "right") if (title := axes.get_title(loc))), "")


def _titles(panels: tuple[Axes, ...]) -> dict[Axes, str]:
    """Return the titles: an untitled panel has that of the nearest one above or at the left, and rows have names."""
    titles = {}
    for k, axes in enumerate(panels):
        before = [one for one in reversed(panels[: k + 1]) if _title(one)]
        found = next((_title(one) for one in before if one is axes or _aligned(axes, one, "x")), "")
        found = found or next((_title(one) for one in before if _aligned(axes, one, "y")), "")
        row = next(
            (
                _own(one, "y").rpartition("\n")[0]
                for one in panels
                if "\n" in _own(one, "y") and (one is axes or _aligned(axes, one, "y"))
            ),
            "",
        )
        titles[axes] = ", ".join(_line(part) for part in (found, row) if part)
    return titles


def _line(text: str) -> str:
    return visible(" ".join(text.split("\n")))


def _ticks(axis: Any) -> dict[float, str]:
    """Return the names of ticks; empty if they are the numbers at which they stand."""
    from matplotlib.ticker import FixedLocator

    if not isinstance(axis.get_major_locator(), FixedLocator):
        return {}
    write = axis.get_major_formatter()
    places = axis.get_major_locator().locs
    names = {float(at): visible(", ".join(str(write(at)).split("\n"))) for at in places}
    return names if any(name and not _is_number(name, at) for at, name in names.items()) else {}


def _is_number(name: str, value: float) -> bool:
    try:
        return float(name.replace("\u2212", "-")) == value
    except ValueError:
        return False


def _look(artist: Any) -> tuple[Any, ...] | None:
    """Return the colour and style by which a reader finds a series in the legend."""
    from matplotlib.collections import LineCollection, PathCollection
    from matplotlib.colors import to_rgba
    from matplotlib.lines import Line2D

    kind = type(artist)
    if issubclass(kind, Line2D):
        marker = artist.get_marker()
        style = artist.get_linestyle() if marker in ("None", "none", "", None) else "-"
        return ("line", _rgb(to_rgba(artist.get_color())), style, artist.get_alpha())
    if issubclass(kind, LineCollection) and len(artist.get_colors()):
        return ("line", _rgb(artist.get_colors()[0]), "-", artist.get_alpha())
    if issubclass(kind, PathCollection) and len(artist.get_edgecolors()) and artist.get_array() is None:
        return ("marks", _rgb(artist.get_edgecolors()[0]), len(artist.get_facecolors()))
    return None


def _rgb(colour: Any) -> tuple[int, ...]:
    return tuple(round(float(part) / SAME) for part in colour[:3])
