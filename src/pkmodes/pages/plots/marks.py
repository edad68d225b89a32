"""How measured modes are marked in every figure, so that a legend has to be learnt once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.labels import short
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, INK, PURPLE, VERMILLION

Array = NDArray[np.float64]
#: Above this number, marks are rasterised to keep the figure small.
MANY = 1500
#: Area of the smallest mark [square points].
SMALLEST = 2.0
#: Differences within this many standard deviations may be noise.
NOISE = 2.0
#: Most setups named on an axis.
NAMED = 30
#: Kinds of rows: fitted, held out, set aside, without a partner.
FITTED: dict[str, Any] = {"marker": "o", "facecolor": BLUE, "edgecolor": BLUE, "label": "fitted"}
HELD_OUT: dict[str, Any] = {
    "marker": "D",
    "facecolor": "none",
    "edgecolor": BLUE,
    "label": "held out",
}
OUTLIER: dict[str, Any] = {"marker": "X", "facecolor": PURPLE, "edgecolor": PURPLE, "label": "set aside"}
UNMATCHED: dict[str, Any] = {"marker": "x", "facecolor": VERMILLION, "label": "unmatched"}
COMPARED: dict[str, Any] = {**FITTED, "label": "measured mode"}


def rows(panel: Panel, evidence: PlottedEvidence, x: Array, y: Array, size: float = 16.0) -> None:
    """Mark each row at (x, y) by its kind; rows with a NaN are left out."""
    shown = np.isfinite(x) & np.isfinite(y)
    compared = len(evidence.stages) == 1
    kinds = (
        (~evidence.held_out & ~evidence.outlier, COMPARED if compared else FITTED),
        (evidence.held_out & ~evidence.outlier, HELD_OUT),
        (evidence.outlier, OUTLIER),
    )
    count = max(int(shown.sum()), 1)
    for of_kind, kind in kinds:
        chosen = shown & of_kind
        if chosen.any():
            panel.scatter(
                x[chosen],
                y[chosen],
                s=max(size * min(1.0, MANY / count), SMALLEST),
                linewidth=0.8,
                zorder=3,
                rasterized=count > MANY,
                **kind,
            )


def legend(sheet: Sheet, panel: Panel, *, beside: bool = False) -> None:
    """Show a legend above a panel if there is more than one kind of marks.

    - beside: whether it may reach over the panel to the left, which has a title of its own at its left end
    """
    handles, labels = panel.axes.get_legend_handles_labels()
    first = dict(zip(reversed(labels), reversed(handles), strict=True))
    names = list(dict.fromkeys(labels))
    if len(names) > 1:
        box = sheet.legend_of(
            [first[name] for name in names],
            names,
            above=panel,
            loc="lower right",
            bbox_to_anchor=(1.0, 1.0),
            ncols=len(names),
            columnspacing=1.2,
            handletextpad=0.4,
        )
        box.set_in_layout(sheet.narrow or not beside)


def zero(panel: Panel) -> None:
    """Draw the line of no difference."""
    panel.axes.axhline(0.0, color=INK, linewidth=0.8, zorder=1)


def zero_across(panel: Panel) -> None:
    """Draw the line of no change of a figure with a horizontal scale."""
    panel.axes.axvline(0.0, color=INK, linewidth=0.8, zorder=1)


def noise(panel: Panel, sigmas: Array) -> None:
    """Shade the differences that noise explains, and scale the axis for all differences and somewhat more than noise.

    - sigmas: differences in standard deviations, (R,)
    """
    panel.axes.axhspan(-NOISE, NOISE, color=GREY, alpha=0.16, linewidth=0, zorder=0)
    finite = sigmas[np.isfinite(sigmas)]
    limit = 1.08 * max(1.5 * NOISE, float(np.abs(finite).max(initial=0.0)))
    panel.axes.set_ylim(-limit, limit)


def setups(panel: Panel, evidence: PlottedEvidence, *, grid: bool = False) -> str:
    """Name the setups on the horizontal axis unless there are many; return its label.

    - grid: whether named setups have lines of the grid
    """
    labels = [short(label) for label in evidence.labels]
    if len(labels) > NAMED:
        return f"{evidence.place}, in the order of their labels"
    turned = len(labels) * max(map(len, labels)) > 90
    panel.name_places("x", range(len(labels)), labels, rotation=90 if turned else 0)
    panel.axes.grid(visible=grid, axis="x")
    return evidence.place
