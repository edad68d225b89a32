"""How measured modes are marked in every figure, so that readers need to learn the legend only once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.labels import short_label
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, INK, PURPLE, VERMILLION

Array = NDArray[np.float64]
#: Above this number, marks are rasterised to keep the figure small.
RASTERIZE_ABOVE = 1500
#: Area of the smallest mark [square points].
MIN_MARK_AREA = 2.0
#: Differences within this many standard deviations may be noise.
NOISE_SIGMAS = 2.0
#: Maximum number of setups named on an axis.
MAX_NAMED_SETUPS = 30
#: Styles of rows: fitted, held out, set aside, without a partner; and of all rows where nothing is fitted.
FITTED_STYLE: dict[str, Any] = {"marker": "o", "facecolor": BLUE, "edgecolor": BLUE, "label": "fitted"}
HELD_OUT_STYLE: dict[str, Any] = {
    "marker": "D",
    "facecolor": "none",
    "edgecolor": BLUE,
    "label": "held out",
}
OUTLIER_STYLE: dict[str, Any] = {
    "marker": "X",
    "facecolor": PURPLE,
    "edgecolor": PURPLE,
    "label": "set aside",
}
UNMATCHED_STYLE: dict[str, Any] = {"marker": "x", "facecolor": VERMILLION, "label": "unmatched"}
COMPARISON_STYLE: dict[str, Any] = {**FITTED_STYLE, "label": "measured mode"}


def mark_rows(panel: Panel, evidence: PlottedEvidence, x: Array, y: Array, size: float = 16.0) -> None:
    """Mark each row at (x, y) by its kind; rows with a NaN are left out."""
    is_finite = np.isfinite(x) & np.isfinite(y)
    is_comparison = len(evidence.stages) == 1
    kinds = (
        (~evidence.held_out & ~evidence.outlier, COMPARISON_STYLE if is_comparison else FITTED_STYLE),
        (evidence.held_out & ~evidence.outlier, HELD_OUT_STYLE),
        (evidence.outlier, OUTLIER_STYLE),
    )
    count = max(int(is_finite.sum()), 1)
    for mask, style in kinds:
        selected = is_finite & mask
        if selected.any():
            panel.scatter(
                x[selected],
                y[selected],
                s=max(size * min(1.0, RASTERIZE_ABOVE / count), MIN_MARK_AREA),
                linewidth=0.8,
                zorder=3,
                rasterized=count > RASTERIZE_ABOVE,
                **style,
            )


def add_legend(sheet: Sheet, panel: Panel, *, may_extend_left: bool = False) -> None:
    """Draw a legend above a panel if there is more than one kind of marks.

    - may_extend_left: whether the legend may extend over the neighbouring panel on the left, whose title
      is left-aligned
    """
    handles, labels = panel.axes.get_legend_handles_labels()
    handle_by_label = dict(zip(reversed(labels), reversed(handles), strict=True))
    names = list(dict.fromkeys(labels))
    if len(names) > 1:
        box = sheet.legend_from_handles(
            [handle_by_label[name] for name in names],
            names,
            above_panel=panel,
            loc="lower right",
            bbox_to_anchor=(1.0, 1.0),
            ncols=len(names),
            columnspacing=1.2,
            handletextpad=0.4,
        )
        box.set_in_layout(sheet.narrow or not may_extend_left)


def draw_zero_line(panel: Panel) -> None:
    """Draw a horizontal line at 0."""
    panel.axes.axhline(0.0, color=INK, linewidth=0.8, zorder=1)


def draw_vertical_zero_line(panel: Panel) -> None:
    """Draw a vertical line at 0."""
    panel.axes.axvline(0.0, color=INK, linewidth=0.8, zorder=1)


def shade_noise_band(panel: Panel, sigmas: Array) -> None:
    """Shade the differences that may be noise, and set the axis limits.

    The limits include every difference and at least 1.5 times the noise band.

    - sigmas: differences in standard deviations, (R,)
    """
    panel.axes.axhspan(-NOISE_SIGMAS, NOISE_SIGMAS, color=GREY, alpha=0.16, linewidth=0, zorder=0)
    finite = sigmas[np.isfinite(sigmas)]
    limit = 1.08 * max(1.5 * NOISE_SIGMAS, float(np.abs(finite).max(initial=0.0)))
    panel.axes.set_ylim(-limit, limit)


def label_setups(panel: Panel, evidence: PlottedEvidence, *, grid: bool = False) -> str:
    """Name the setups on the horizontal axis unless there are many; return the label of the axis.

    - grid: whether to draw a grid line at each named setup
    """
    labels = [short_label(label) for label in evidence.labels]
    if len(labels) > MAX_NAMED_SETUPS:
        return f"{evidence.setup_noun}, in the order of their labels"
    rotate_labels = len(labels) * max(map(len, labels)) > 90
    panel.set_tick_names("x", range(len(labels)), labels, rotation=90 if rotate_labels else 0)
    panel.axes.grid(visible=grid, axis="x")
    return evidence.setup_noun
