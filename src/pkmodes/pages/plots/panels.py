"""Panels of a figure, one for each mode, with their colour scales."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.plane import Plane
from pkmodes.pages.plots.sheet import Scales, Sheet
from pkmodes.pages.plots.style import FIGURE_WIDTH

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Space for labels and colour bars beside and below each panel, and for a line below its title [inch].
SPACE_BESIDE, SPACE_BELOW, TEXT_LINE_HEIGHT = 0.62, 1.0, 0.15
#: Height of a colour bar below a panel, its distance from the labels above it, and the distance between two of its
#: numbers [inch].
BAR_THICKNESS, BAR_CLEARANCE, NUMBER_GAP = 0.08, 0.07, 0.05
#: Minimum width of a colour bar below a panel [inch].
MIN_BAR_WIDTH = 0.7
#: Font size of the numbers on colour bars [points], and width of a digit relative to it.
BAR_FONT_SIZE, DIGIT_WIDTH = 6.5, 0.64
#: Maximum ratio of height to width of a panel, and its maximum height [inch].
MAX_HEIGHT_TO_WIDTH, MAX_PANEL_HEIGHT = 3.5, 4.5
#: Maximum number of tall panels in a row; for other panels, the number of modes that counts as few, and the maximum
#: number in a row for few and for many modes.
MAX_TALL_COLUMNS, FEW_MODES, MAX_COLUMNS_FEW_MODES, MAX_COLUMNS_MANY_MODES = 6, 6, 3, 4
#: Minimum span of a colour scale of frequencies, relative to the frequency, so that a small range also looks small.
MIN_RELATIVE_SPAN = 0.05


def rows_and_columns(modes: int, *, is_tall: bool) -> tuple[int, int]:
    """Return the rows and columns of panels: as many in a row as fit, with rows of nearly equal length."""
    max_columns = MAX_COLUMNS_FEW_MODES if modes <= FEW_MODES else MAX_COLUMNS_MANY_MODES
    if is_tall:
        max_columns = MAX_TALL_COLUMNS
    rows = -(-modes // max_columns)
    return rows, -(-modes // rows)


def mode_panels(
    sheet: Sheet,
    plane: Plane,
    modes: int,
    *,
    scales: Scales = "",
    has_text_line: bool = False,
    space_below: float = 0.0,
) -> Iterator[tuple[int, Panel]]:
    """Yield each mode with its panel, which has a title, and labels where no panel is at the left or below.

    - scales: as for `pkmodes.pages.plots.sheet.Sheet.groups`
    - has_text_line: whether there is a line of text between title and panel
    - space_below: height to be left free below all panels [inch]
    """
    rows, columns = rows_and_columns(modes, is_tall=plane.is_tall)
    colour_bars = scales == "own"
    panel_height = min(
        min(plane.height_to_width, MAX_HEIGHT_TO_WIDTH) * panel_width(plane, modes, colour_bars=colour_bars),
        MAX_PANEL_HEIGHT,
    )
    height = (
        panel_height
        + (SPACE_BELOW if colour_bars and plane.is_tall else 0.25)
        + (TEXT_LINE_HEIGHT if has_text_line else 0.0)
    )
    sheet.figure.set_layout_engine("compressed")  # panels keep their proportions and stand close together
    height = rows * (height + 0.3) + 0.3 + space_below
    sheet.groups(modes, columns, height, height_to_width=plane.fixed_height_to_width, scales=scales)
    pad = 72 * TEXT_LINE_HEIGHT + 3 if has_text_line else None  # [points]
    for mode, panel in enumerate(sheet.panels):
        plane.label_panel(panel, f"mode {mode + 1}", pad=pad)
        yield mode, panel


def panel_width(plane: Plane, modes: int, *, colour_bars: bool) -> float:
    """Return the approximate width of a panel [inch]."""
    columns = rows_and_columns(modes, is_tall=plane.is_tall)[1]
    return FIGURE_WIDTH / columns - (SPACE_BESIDE if colour_bars and not plane.is_tall else 0.15)


def draw_own_scale(plane: Plane, panel: Panel, mesh: Any, label: str) -> None:
    """Draw the colour scale of one panel: below a tall map, to the right of others."""
    from matplotlib.ticker import MaxNLocator

    panel.labels["scale"], axes = label, panel.axes
    inset = axes.inset_axes((0.0, -0.5, 1.0, 0.05) if plane.is_tall else (1.05, 0.0, 0.06, 1.0))
    if plane.is_tall:
        inset.set_axes_locator(_locator_below_labels(axes))
    orientation = "horizontal" if plane.is_tall else "vertical"
    bar = axes.figure.colorbar(mesh, cax=inset, orientation=orientation, extend="both")
    bar.set_label(label)
    if plane.is_tall:
        bar.locator = _separate_ticks_locator(*mesh.get_clim())
    else:
        bar.locator = MaxNLocator(5, steps=[1, 2, 2.5, 5, 10], min_n_ticks=3)
    bar.update_ticks()
    bar.ax.tick_params(length=2, labelsize=BAR_FONT_SIZE)


def _locator_below_labels(axes: Axes) -> Any:
    """Return a locator for a colour bar: as wide as a panel, below the labels of its horizontal axis."""
    from matplotlib.transforms import Bbox

    def locate(_: Any, renderer: Any) -> Any:
        figure: Any = axes.figure
        labels = axes.xaxis.get_tightbbox(renderer)
        top = (axes.bbox.y0 if labels is None else min(labels.y0, axes.bbox.y0)) - BAR_CLEARANCE * figure.dpi
        box = Bbox.from_extents(axes.bbox.x0, top - BAR_THICKNESS * figure.dpi, axes.bbox.x1, top)
        return figure.transFigure.inverted().transform_bbox(box)

    return locate


def _separate_ticks_locator(low: float, high: float) -> Any:
    """Return a locator of two or three ticks whose numbers do not touch, for a colour bar below a panel."""
    from matplotlib.ticker import MaxNLocator

    steps = [1, 1.5, 2, 3, 4, 5, 6, 8, 10]
    for count in (3, 2):
        locator = MaxNLocator(count, steps=steps, min_n_ticks=count)
        ticks = [tick for tick in locator.tick_values(low, high) if low <= tick <= high]
        if len(ticks) < 2:
            continue
        longest_number = max(len(f"{tick:.6g}") for tick in ticks) * DIGIT_WIDTH * BAR_FONT_SIZE / 72
        if MIN_BAR_WIDTH * (ticks[1] - ticks[0]) / (high - low) >= longest_number + NUMBER_GAP:
            return locator
    return MaxNLocator(2, steps=[1, 2, 2.5, 5, 10], min_n_ticks=2)


def draw_shared_scale(sheet: Sheet, plane: Plane, mesh: Any, label: str, **settings: Any) -> None:
    """Draw the colour scale of all panels: to the right of tall maps, below others."""
    location, shrink = ("right", 0.9) if plane.is_tall else ("bottom", 0.6)
    sheet.colour_scale(mesh, label, location=location, shrink=shrink, aspect=35, **settings)


def widened_limits(low: float, high: float) -> tuple[float, float]:
    """Return the ends of a scale of frequencies that spans at least `MIN_RELATIVE_SPAN` of them."""
    half_span = max(high - low, MIN_RELATIVE_SPAN * abs(low + high) / 2) / 2
    middle = (low + high) / 2
    return (low, high) if 2 * half_span <= high - low else (middle - half_span, middle + half_span)
