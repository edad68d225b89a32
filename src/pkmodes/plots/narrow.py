"""A figure laid out anew for a narrow screen: its panels one below the other, each with its labels."""

from __future__ import annotations

import itertools
from textwrap import fill
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.legend import Legend

#: Width of a narrow figure, some 340 px of a page [inch].
NARROW = 3.5
#: Space for labels beside a panel, for a scale there, and for title and labels above and below it [inch].
LABELS, SCALE, AROUND = 0.75, 0.65, 0.75
#: Height of a panel over its width from which on two and three stand side by side.
TALL = (1.3, 2.2)
#: Space for a scale below a panel [inch].
BELOW = 0.6
#: How far a figure may reach over its width until it is taken for one that does not fit.
SLACK = 1.03
#: Width of a panel at least [inch].
LEAST = 0.5
#: Characters of a title or label in one line.
LINE = 44
#: How often the height of a figure is adapted to its width.
ROUNDS = 3
#: Distance of the labels of ticks that are not turned [inch].
APART = 0.04


def narrowed(figure: Figure) -> bool:
    """Lay a figure out anew, as wide as `NARROW`.

    The panels of its grid follow each other as they are read: row by row, or column by column where only the first
    row has titles.  Panels that shared the labels of others get their own.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        It is changed, as well if it does not fit.

    Returns
    -------
    bool
        Whether it fits.
    """
    grid = _grid(figure)
    if grid is None:
        return False
    figure.draw_without_rendering()
    places = _places(grid)
    if not places:
        return False
    ratio = min(_ratio(axes) for axes in places.values())
    bare = not any(axes.axison for axes in places.values())
    columns = min(len(places), 3 if bare else 1 + sum(ratio >= one for one in TALL))
    order = _order(places) if columns == 1 else list(places)
    rows = -(-len(order) // columns)
    heights = [_height(figure, places[place], columns) for place in order]
    labels = [_labels(places, place) for place in order]
    per_row = [max(heights[columns * i : columns * (i + 1)]) for i in range(rows)]
    figure.set_size_inches(NARROW, sum(per_row) + rows * AROUND + 0.3)
    spec = figure.add_gridspec(rows, columns, height_ratios=per_row)
    for k, place in enumerate(order):
        for axes in grid[place]:
            axes.set_subplotspec(spec[k // columns, k % columns])
        inner = k % columns > 0 and labels[k][2] == labels[k - 1][2]
        _label(places[place], *labels[k], inner=inner)
    for place in grid:
        if place not in order:
            for axes in grid[place]:
                axes.remove()
    _legends(figure)
    panels = [places[place] for place in order]
    _fill(figure, panels, columns)
    _turn(figure)
    _break(figure)
    _fill(figure, panels, columns)
    figure.set_layout_engine("none")  # it stays as it is
    for axes in figure.axes:
        legend = axes.get_legend()
        if legend is not None:
            legend.set_in_layout(True)  # no more for the layout, but for the margins
    wide = figure.get_tightbbox().width > SLACK * NARROW
    thin = any(axes.bbox.width < LEAST * figure.dpi for axes in places.values())
    return not (wide or thin or any(_crowded(axes) for axes in places.values()))


def _crowded(axes: Axes) -> bool:
    """Return whether texts in a panel lie on each other."""
    boxes = [text.get_window_extent() for text in axes.texts if text.get_text() and text.get_visible()]
    return any(a.overlaps(b) for a, b in itertools.pairwise(boxes))


def _grid(figure: Figure) -> dict[tuple[int, int], list[Axes]] | None:
    """Return the axes of a figure by row and column; None if they are not in one grid."""
    if figure.subfigs:
        return None
    found: dict[tuple[int, int], list[Axes]] = {}
    specs = set()
    for axes in figure.axes:
        spec = axes.get_subplotspec()
        if spec is None:
            continue  # a scale, or an inset
        specs.add(spec.get_gridspec())
        found.setdefault((spec.rowspan.start, spec.colspan.start), []).append(axes)
    return found if len(specs) == 1 else None


def _places(grid: dict[tuple[int, int], list[Axes]]) -> dict[tuple[int, int], Axes]:
    """Return the panels that are drawn, by row and column."""
    return {
        place: axes[0] for place, axes in sorted(grid.items()) if axes[0].axison and axes[0].get_visible()
    }


def _order(places: dict[tuple[int, int], Axes]) -> list[tuple[int, int]]:
    """Return the places of the panels as they are read: rows from one with titles to the next belong together."""
    blocks: list[list[tuple[int, int]]] = []
    for row in sorted({row for row, _ in places}):
        own = [place for place in places if place[0] == row]
        if not blocks or any(_title(places[place]) for place in own):
            blocks.append([])
        blocks[-1] += own
    return [place for block in blocks for place in sorted(block, key=lambda place: place[::-1])]


def _ratio(axes: Axes) -> float:
    """Return height over width of a panel that keeps its proportions; 0 for another."""
    if axes.get_aspect() == "auto":
        return 0.0
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    return abs(high - low) / abs(right - left)


def _height(figure: Figure, axes: Axes, columns: int) -> float:
    """Return the height of a panel [inch]."""
    ratio = _ratio(axes)
    if not ratio:
        return float(axes.get_position().height * figure.get_figheight())
    common = any(one.get_subplotspec() is None for one in figure.axes)
    own = bool(axes.child_axes) and columns == 1
    width = (NARROW - LABELS - (SCALE if common or own else 0.0)) / columns
    return ratio * width + (BELOW if axes.child_axes and columns > 1 else 0.0)


def _title(axes: Axes) -> str:
    return axes.get_title(loc="left")


def _labels(places: dict[tuple[int, int], Axes], place: tuple[int, int]) -> tuple[str, str, str]:
    """Return title and labels of a panel: its own, or those of the panel from which it is read."""
    row, column = place
    beside = [places[one] for one in sorted(places) if one[0] == row]
    above = [places[one] for one in sorted(places) if one[1] == column]
    axes = places[place]
    nearest = [places[one] for one in sorted(places, reverse=True) if one[1] == column and one[0] <= row]
    title = next((title for one in nearest if (title := _title(one))), "") or _title(beside[0])
    across = axes.get_xlabel() or above[-1].get_xlabel() or places[max(places)].get_xlabel()
    return title, across, axes.get_ylabel() or beside[0].get_ylabel()


def _label(axes: Axes, title: str, across: str, along: str, *, inner: bool) -> None:
    own: Any = axes._left_title  # type: ignore[attr-defined]
    if own.get_text():
        own.set_text(fill(title, LINE))  # it keeps its distance
    else:
        axes.set_title(fill(title, LINE))
    axes.set_xlabel("\n".join(fill(line, LINE) for line in across.split("\n")))
    axes.set_ylabel("" if inner else along)
    axes.tick_params(labelbottom=True, labelleft=not inner)


def _legends(figure: Figure) -> None:
    """Make legends of the figure and those above a panel anew, in as many columns as there is space for."""
    figure.draw_without_rendering()
    for legend in list(figure.legends):
        figure.legends.remove(legend)
        title = legend.get_title().get_text()
        settings = {"loc": "outside lower center", **({"title": title} if title else {})}
        _fitted(figure, figure, legend, settings)
    for axes in figure.axes:
        above = axes.get_legend()
        if above is None or above.get_window_extent().y1 < axes.bbox.y1:
            continue
        above_it = [axes._left_title] if _title(axes) else []  # type: ignore[attr-defined]
        above_it += [text for text in axes.texts if text.get_visible() and text.get_text()]
        made = _fitted(figure, axes, above, {"loc": "lower right", "bbox_to_anchor": (1.0, 1.0)})
        boxes = [text.get_window_extent() for text in above_it]
        over = [box.y1 for box in boxes if box.y1 > axes.bbox.y1]
        if any(made.get_window_extent().overlaps(box) for box in boxes):
            top = (max(over, default=axes.bbox.y1) - axes.bbox.y0) / axes.bbox.height
            made.set_bbox_to_anchor((1.0, top), axes.transAxes)


def _fitted(figure: Figure, owner: Any, legend: Legend, settings: dict[str, Any]) -> Legend:
    """Make a legend anew, above a panel or below a figure, no wider than the figure."""
    names = [text.get_text() for text in legend.get_texts()]
    handles = legend.legend_handles
    for columns in range(len(names), 0, -1):
        made: Legend = owner.legend(
            handles, names, ncols=columns, columnspacing=1.2, handletextpad=0.4, **settings
        )
        made.set_in_layout(owner is figure)  # one above a panel may reach over the labels beside it
        # Its texts alone make its width: nothing is drawn for it.
        if columns == 1 or made.get_window_extent().width <= (NARROW - 0.1) * figure.dpi:
            break
        made.remove()
    figure.draw_without_rendering()
    return made


def _fill(figure: Figure, panels: list[Axes], columns: int) -> None:
    """Make a figure as high as panels side by side that keep their proportions need to fill its width."""
    ratios = [_ratio(axes) for axes in panels]
    for _ in range(ROUNDS):
        figure.draw_without_rendering()
        if columns == 1 or not all(ratios):
            return
        left = (NARROW - figure.get_tightbbox().width - 2 * APART) / columns
        if abs(left) < APART / columns:
            return
        taller = [left * max(ratios[i : i + columns]) for i in range(0, len(ratios), columns)]
        figure.set_figheight(figure.get_figheight() + sum(taller))


def _turn(figure: Figure) -> None:
    """Turn the labels of ticks that would lie on each other."""
    for axes in figure.axes:
        shown = [label for label in axes.get_xticklabels() if label.get_text() and label.get_visible()]
        boxes = sorted((label.get_window_extent() for label in shown), key=lambda box: box.x0)
        gap = APART * figure.dpi
        if any(a.x1 + gap > b.x0 for a, b in itertools.pairwise(boxes)) and shown[0].get_rotation() == 0:
            axes.tick_params(axis="x", labelrotation=90)


def _break(figure: Figure) -> None:
    """Break labels that reach over the edge into shorter lines."""
    for axes in figure.axes:
        label = axes.xaxis.label
        if label.get_window_extent().x1 > figure.bbox.x1:
            label.set_text(fill(" ".join(label.get_text().split()), LINE // 2))
