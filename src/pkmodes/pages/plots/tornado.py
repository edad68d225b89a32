"""Tornado charts: what one per cent or one sigma of each quantity does to each frequency, the largest on top."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any

import numpy as np

from pkmodes.loop.sensitivity.changes import PERCENT, SIGMA, Changes
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import typeset, visible_text
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, INK, PAPER

#: Maximum numbers of bars in a panel, of panels side by side, and of panels in a figure that fits a printed page.
MAX_BARS, MAX_COLUMNS, MAX_PANELS = 10, 2, 6
#: Names longer than this are split before their last part.
MAX_NAME_LENGTH = 24
#: Height of a bar with its spacing, of a line of its label, and of the space around the bars of a panel [inch].
BAR_PITCH, LABEL_LINE, PANEL_PADDING = 0.23, 0.13, 0.75
#: Length of the shortest bar that is drawn, as a fraction of the longest.
MIN_BAR_FRACTION = 1e-3
#: Length of the axis relative to the longest bar.
AXIS_MARGIN = 1.06
#: Bars for an increase of the quantity are filled, those for a decrease hollow, so that they differ without colour.
INCREASE_STYLE: dict[str, Any] = {"color": BLUE, "edgecolor": BLUE}
DECREASE_STYLE: dict[str, Any] = {"color": PAPER, "edgecolor": BLUE}
TOGETHER_STYLE: dict[str, Any] = {"color": GREY, "edgecolor": GREY}
TOGETHER_LABEL = "all together"
#: Labels of the step by which each quantity changes.
STEP_LABELS = {PERCENT: "1 %", SIGMA: "one sigma"}


def tornado(changes: Changes, modes: Sequence[int] | None = None) -> Drawing:
    """Draw the largest changes of each frequency, one panel for each mode.

    - changes: from `pkmodes.loop.sensitivity.changes.changes_at`
    - modes: modes that are drawn, counted from 0; by default all
    """
    shown_modes = range(len(changes.frequencies)) if modes is None else modes
    columns = min(MAX_COLUMNS, len(shown_modes))
    rows = -(-len(shown_modes) // columns)
    bars = max(len(_shown_quantities(changes, mode)) for mode in shown_modes) + (changes.combined is not None)
    height = rows * (_bar_pitch(changes, shown_modes) * bars + PANEL_PADDING) + 0.3

    def draw(sheet: Sheet) -> None:
        from matplotlib.layout_engine import ConstrainedLayoutEngine
        from matplotlib.patches import Patch

        sheet.figure.set_layout_engine(ConstrainedLayoutEngine(h_pad=0.08))  # a title is near its own panel
        sheet.groups(len(shown_modes), columns, height)
        for mode, panel in zip(shown_modes, sheet.panels, strict=True):
            _draw_panel(panel, changes, mode, bars)
        step = STEP_LABELS[changes.by]
        handles = [
            Patch(label=f"{step} more", facecolor=INCREASE_STYLE["color"], edgecolor=BLUE),
            Patch(label=f"{step} less", facecolor=DECREASE_STYLE["color"], edgecolor=BLUE),
        ]
        if changes.combined is not None:
            handles.append(
                Patch(label=f"{TOGETHER_LABEL}: standard deviation", facecolor=GREY, edgecolor=GREY)
            )
        names = [str(handle.get_label()) for handle in handles]
        sheet.legend_from_handles(handles, names, loc="outside upper right", ncols=len(handles))

    return Drawing(draw)


def wrapped_name(name: str) -> str:
    """Return a name, wrapped to fit the space beside a panel."""
    text = visible_text(name)
    if len(text) <= MAX_NAME_LENGTH or "." not in text:
        return text
    head, _, last = text.rpartition(".")
    return f"{head}\n.{last}"


def _label_of(changes: Changes, index: int) -> str:
    """Return the names of a quantity beside a panel, each on lines of its own."""
    return ",\n".join(map(wrapped_name, changes.names[index]))


def _bar_pitch(changes: Changes, modes: Sequence[int]) -> float:
    """Return the height of a bar with its spacing for which labels of several lines leave their neighbours alone."""
    pitch = BAR_PITCH
    for mode in modes:
        lines = [1 + _label_of(changes, i).count("\n") for i in _shown_quantities(changes, mode)]
        pitch = max([pitch, *(0.5 * (a + b) * LABEL_LINE for a, b in itertools.pairwise([*lines, 1]))])
    return pitch


def _shown_quantities(changes: Changes, mode: int) -> list[int]:
    magnitudes = np.abs(changes.changes[:, mode])
    return [i for i in changes.largest(mode, MAX_BARS) if magnitudes[i] > MIN_BAR_FRACTION * magnitudes.max()]


def _draw_panel(panel: Panel, changes: Changes, mode: int, bars: int) -> None:
    axes, largest = panel.axes, _shown_quantities(changes, mode)
    names = [", ".join(map(visible_text, changes.names[i])) for i in largest]
    wrapped_labels = [_label_of(changes, i) for i in largest]
    style: dict[str, Any] = {"height": 0.66, "linewidth": 0.8}
    step = STEP_LABELS[changes.by]
    for row, i in enumerate(largest):
        change = float(changes.changes[i, mode])
        panel.bar(row, 0.0, change, label=f"{step} more", **style, **INCREASE_STYLE)
        panel.bar(row, 0.0, -change, label=f"{step} less", **style, **DECREASE_STYLE)
    if changes.combined is not None:
        sigma = float(changes.combined[mode])
        panel.bar(len(names), -sigma, sigma, label=TOGETHER_LABEL, **style, **TOGETHER_STYLE)
        names, wrapped_labels = [*names, TOGETHER_LABEL], [*wrapped_labels, TOGETHER_LABEL]
    panel.axes.axvline(0.0, color=INK, linewidth=0.8)
    panel.set_tick_names("y", range(len(names)), wrapped_labels, names, fontsize=7, linespacing=0.95)
    axes.set_ylim(bars - 0.4, -0.6)  # the largest on top, bars equally wide in all panels
    axes.tick_params(axis="y", length=0)
    axes.grid(visible=False, axis="y")
    longest = max(
        [float(np.abs(changes.changes[largest, mode]).max(initial=0.0))]
        + ([] if changes.combined is None else [float(changes.combined[mode])])
    )
    if longest > 0.0:
        axes.set_xlim(-AXIS_MARGIN * longest, AXIS_MARGIN * longest)
    axes.locator_params(axis="x", nbins=5)
    title = f"mode {mode + 1}, {typeset(f'{changes.frequencies[mode]:.2f}')} Hz"
    panel.omitted_labels.clear()  # every panel has its own scale, so it shows its own labels
    panel.label(title, x="change of the frequency [Hz]")
