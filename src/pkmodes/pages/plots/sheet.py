"""The sheet on which a figure is drawn: as wide as the text of a page, or narrow with panels below one another."""

from __future__ import annotations

import itertools
from collections.abc import Container, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, Literal

from pkmodes.pages.plots.panel import LabelKind, Panel
from pkmodes.pages.plots.style import FIGURE_WIDTH, figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.transforms import Bbox

Shared = bool | Literal["row", "col"]
Scales = Literal["", "own", "common"]
#: Width of a narrow figure, about 340 px on a page [inch].
NARROW_WIDTH = 3.5
#: Space beside a panel for labels and for a colour scale, and above and below it for title and labels [inch].
LABEL_WIDTH, SCALE_WIDTH, LABEL_HEIGHT = 0.75, 0.65, 0.75
#: Space for the title of a panel without axes, and for a colour scale below a panel [inch].
TITLE_HEIGHT, SCALE_HEIGHT = 0.25, 0.6
#: Approximate height of titles and labels around a panel on a wide sheet [inch].
WIDE_LABEL_HEIGHT = 0.55
#: Ratios of height to width from which two and three panels stand side by side on a narrow sheet.
SIDE_BY_SIDE_RATIOS = (1.3, 2.2)
#: A drawn figure fits a narrow sheet if its width is at most this multiple of the width of the sheet.
MAX_WIDTH_RATIO = 1.03
#: Minimum width of a panel [inch].
MIN_PANEL_WIDTH = 0.5
#: Minimum distance between tick labels that are not rotated [inch].
TICK_LABEL_GAP = 0.04
#: Margin around narrow figures [inch].
MARGIN = 0.08


class Sheet:
    """A sheet with the panels that are drawn on it.

    - panels: in the order of the rows of a wide sheet
    - panel_width: approximate width of a panel on a narrow sheet [inch]
    """

    def __init__(self, *, narrow: bool) -> None:
        self.narrow = narrow
        self.figure = figure(1.0)
        self.panels: list[Panel] = []
        self.panel_width = NARROW_WIDTH

    def panel(self, height: float, width: float = FIGURE_WIDTH, **settings: Any) -> Panel:
        """Return the only panel of a figure; the parameters are those of `groups`."""
        return self.groups(1, 1, height, width, **settings)[0][0]

    def groups(
        self,
        count: int,
        columns: int,
        height: float,
        width: float = FIGURE_WIDTH,
        *,
        rows: Sequence[float] = (1.0,),
        share_x: Shared = False,
        share_y: Shared = False,
        height_to_width: float = 0.0,
        scales: Scales = "",
        frames: bool = True,
    ) -> list[list[Panel]]:
        """Return groups of panels; the panels of a group stand below one another and are read together.

        On a wide sheet only the first panel of a group has a title, and only the panels at the left and at the bottom
        have axis labels.  On a narrow sheet the groups stand below one another, and slender panels side by side.

        - count, columns: number of groups, and of columns of groups on a wide sheet
        - height, width: of the wide figure [inch]
        - rows: relative heights of the panels of a group
        - share_x, share_y: as for `matplotlib.figure.Figure.subplots`
        - height_to_width: height over width of panels that keep their proportions; 0 for others
        - scales: the colour scales beside the panels: one for each (``own``), one for all (``common``), or none
        - frames: whether the panels have axes; without axes, more panels stand side by side
        """
        panel_lines = -(-count // columns)
        cell_of_panel = {
            (group, row): (group // columns * len(rows) + row, group % columns)
            for group in range(count)
            for row in range(len(rows))
        }
        if self.narrow:
            panels_per_row = min(
                len(cell_of_panel),
                1 + sum(height_to_width >= ratio for ratio in SIDE_BY_SIDE_RATIOS) if frames else 3,
            )
            scale_width = (
                SCALE_WIDTH if scales == "common" or (scales == "own" and panels_per_row == 1) else 0.0
            )
            self.panel_width = (
                NARROW_WIDTH - (LABEL_WIDTH if frames else 0.0) - scale_width
            ) / panels_per_row
            heights = [(height / panel_lines - WIDE_LABEL_HEIGHT) * row / sum(rows) for row in rows]
            if height_to_width:
                scale_height = SCALE_HEIGHT if scales == "own" and panels_per_row > 1 else 0.0
                heights = [height_to_width * self.panel_width + scale_height] * len(rows)
            label_height = LABEL_HEIGHT if frames else TITLE_HEIGHT
            panels = self._add_narrow_panels(
                cell_of_panel, panels_per_row, heights, label_height, scale_width, share_x, share_y
            )
        else:
            self.figure.set_size_inches(width, height)
            grid_settings = {"height_ratios": list(rows) * panel_lines} if len(rows) > 1 else {}
            grid_shape = panel_lines * len(rows), columns
            grid_axes: Any = self.figure.subplots(
                *grid_shape, squeeze=False, sharex=share_x, sharey=share_y, gridspec_kw=grid_settings
            )
            for axes in grid_axes.flat:
                axes.set_visible(False)
            occupied = set(cell_of_panel.values())
            panels = {
                key: Panel(grid_axes[cell], omitted_labels=_omitted_labels(key[1], cell, occupied))
                for key, cell in cell_of_panel.items()
            }
            for panel in panels.values():
                panel.axes.set_visible(True)
        self.panels = [panels[key] for key in sorted(cell_of_panel, key=cell_of_panel.__getitem__)]
        return [[panels[group, row] for row in range(len(rows))] for group in range(count)]

    def _add_narrow_panels(
        self,
        cell_of_panel: dict[tuple[int, int], tuple[int, int]],
        panels_per_row: int,
        heights: Sequence[float],
        label_height: float,
        scale_width: float,
        share_x: Shared,
        share_y: Shared,
    ) -> dict[tuple[int, int], Panel]:
        """Add the panels of a narrow sheet to the figure, and return them by group and row.

        - cell_of_panel: row and column of the panels on a wide sheet
        - panels_per_row: number of panels side by side; one column is in the order of the groups, several columns are
          in the order of the wide sheet
        - label_height, scale_width: space for the labels of each panel, and for a colour scale beside it [inch]
        """
        order = (
            list(cell_of_panel)
            if panels_per_row == 1
            else sorted(cell_of_panel, key=cell_of_panel.__getitem__)
        )
        line_heights = [
            max(heights[row] for _, row in order[k : k + panels_per_row])
            for k in range(0, len(order), panels_per_row)
        ]
        self.figure.set_size_inches(NARROW_WIDTH, sum(line_heights) + len(line_heights) * label_height + 0.3)
        # The margins are about those after the layout: the width decides which numbers and names fit side by side.
        margins = {"left": 0.15, "right": 0.99 - scale_width / NARROW_WIDTH}
        spec = self.figure.add_gridspec(
            len(line_heights), panels_per_row, height_ratios=line_heights, **margins
        )
        first_axes: dict[tuple[str, int], Axes] = {}
        panels: dict[tuple[int, int], Panel] = {}
        for k, panel_key in enumerate(order):
            row, column = cell_of_panel[panel_key]
            keys = [("sharex", column if share_x == "col" else 0)] if share_x else []
            keys += [("sharey", row if share_y == "row" else 0)] if share_y else []
            shared: dict[str, Any] = {key[0]: first_axes.get(key) for key in keys}
            axes = self.figure.add_subplot(spec[k // panels_per_row, k % panels_per_row], **shared)
            first_axes = {**dict.fromkeys(keys, axes), **first_axes}
            panels[panel_key] = Panel(
                axes, narrow=True, left_panel=panels[order[k - 1]] if k % panels_per_row else None
            )
        return panels

    def add_panel(self, axes: Axes, omitted_labels: Iterable[LabelKind] = ()) -> Panel:
        """Add axes that are already on the figure as a panel, and return it."""
        self.panels.append(Panel(axes, omitted_labels=omitted_labels))
        return self.panels[-1]

    def colour_scale(self, mesh: Any, label: str, **settings: Any) -> None:
        """Draw the colour scale of all panels.

        - settings: for `matplotlib.figure.Figure.colorbar`
        """
        for panel in self.panels:
            panel.labels["scale"] = label
        self.figure.colorbar(mesh, ax=[panel.axes for panel in self.panels], **settings).set_label(label)

    def legend(self, panel: Panel, *, above_panel: bool = True, **wide_settings: Any) -> None:
        """Draw the legend of a panel.

        - above_panel: whether it stands above this panel on a wide sheet, or else outside all panels
        - wide_settings: matplotlib settings of the legend on a wide sheet
        """
        self.legend_from_handles(
            *panel.axes.get_legend_handles_labels(),
            above_panel=panel if above_panel else None,
            **wide_settings,
        )

    def legend_from_handles(
        self,
        handles: Sequence[Any],
        names: Sequence[str],
        *,
        above_panel: Panel | None = None,
        below_panels: bool = False,
        title: str | None = None,
        **wide_settings: Any,
    ) -> Any:
        """Draw a legend outside the panels: on a narrow sheet above or below all of them, in as many columns as fit.

        - above_panel: the panel above which it stands on a wide sheet
        - below_panels: whether it stands below all panels on a narrow sheet
        - wide_settings: matplotlib settings of the legend on a wide sheet
        """
        if not self.narrow:
            parent = self.figure if above_panel is None else above_panel.axes
            return parent.legend(handles, names, title=title, **wide_settings)
        placement: dict[str, Any] = {"loc": "outside lower center" if below_panels else "outside upper left"}
        for columns in range(len(names), 0, -1):
            legend = self.figure.legend(
                handles, names, title=title, ncols=columns, columnspacing=1.2, handletextpad=0.4, **placement
            )
            box = legend.get_window_extent()
            if columns == 1 or box.width <= (NARROW_WIDTH - 2 * MARGIN) * self.figure.dpi:
                break
            legend.remove()
        self.figure.set_figheight(self.figure.get_figheight() + box.height / self.figure.dpi)
        return legend

    def lay_out_narrow(self) -> Bbox | None:
        """Lay out a narrow figure before it is saved; return the part of it to be shown, None if it does not fit."""
        from matplotlib import rc_context
        from matplotlib.transforms import Bbox

        figure = self.figure
        for panel in self.panels:
            _rotate_tick_labels(panel.axes, TICK_LABEL_GAP * figure.dpi)
        engine = figure.get_layout_engine()
        if not self.panels or engine is None:
            return None
        engine.execute(figure)
        with rc_context({"figure.constrained_layout.use": False}):
            figure.set_layout_engine(None)  # saved as it is now, without another layout
        # A legend placed relative to the figure does not move when margins are cut off.
        for legend in figure.legends:
            legend.set_bbox_to_anchor((0.0, 0.0, 1.0, 1.0), figure.transFigure)
        box = figure.get_tightbbox()
        too_narrow = any(panel.axes.bbox.width < MIN_PANEL_WIDTH * figure.dpi for panel in self.panels)
        if (
            box.width > MAX_WIDTH_RATIO * NARROW_WIDTH
            or too_narrow
            or any(_has_overlapping_texts(panel.axes) for panel in self.panels)
        ):
            return None
        # Text is drawn in the fonts of the reader, which may be somewhat wider.
        return Bbox([[min(box.x0, 0.0), box.y0], [max(box.x1, NARROW_WIDTH), box.y1]]).padded(MARGIN)


def _omitted_labels(
    row: int, cell: tuple[int, int], occupied: Container[tuple[int, int]]
) -> Iterator[LabelKind]:
    """Yield the labels that a panel leaves to others, from its row in its group and its cell on the sheet."""
    if row:
        yield "title"
    if cell[1]:
        yield "y"
    if (cell[0] + 1, cell[1]) in occupied:
        yield "x"


def _rotate_tick_labels(axes: Axes, gap: float) -> None:
    """Rotate tick labels that would overlap; called before the layout, when panels have about their final width."""
    labels = [label for label in axes.get_xticklabels() if label.get_text() and label.get_visible()]
    boxes = sorted((label.get_window_extent() for label in labels), key=lambda box: box.x0)
    if (
        any(left.x1 + gap > right.x0 for left, right in itertools.pairwise(boxes))
        and labels[0].get_rotation() == 0
    ):
        axes.tick_params(axis="x", labelrotation=90)


def _has_overlapping_texts(axes: Axes) -> bool:
    """Return whether texts in a panel overlap."""
    boxes = [text.get_window_extent() for text in axes.texts if text.get_text() and text.get_visible()]
    return any(box.overlaps(next_box) for box, next_box in itertools.pairwise(boxes))
