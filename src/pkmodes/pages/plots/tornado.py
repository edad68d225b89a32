"""Tornado charts: what one per cent or one sigma of each quantity does to each frequency, the largest on top."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from pkmodes.loop.sensitivity.changes import PERCENT, SIGMA, Changes
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import typeset, visible
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, INK, PAPER

#: Most bars in a panel, panels side by side, and panels in a figure that fits a printed page.
MOST, COLUMNS, PANELS = 10, 2, 6
#: Longest line of a name; longer names are broken before their last part.
LONGEST = 24
#: Height of a bar with its spacing, and of the space around the bars of a panel [inch].
BAR, AROUND = 0.23, 0.6
#: Shortest visible bar as a fraction of the longest, and length of the axis relative to the longest.
LEAST, SPACE = 1e-3, 1.06
#: Rises are filled and falls are not, so that they differ without colour.
RISE: dict[str, Any] = {"color": BLUE, "edgecolor": BLUE}
FALL: dict[str, Any] = {"color": PAPER, "edgecolor": BLUE}
TOGETHER: dict[str, Any] = {"color": GREY, "edgecolor": GREY}
ALL = "all together"
#: Step by which each quantity changes.
STEPS = {PERCENT: "1 %", SIGMA: "one sigma"}


def tornado(changes: Changes, modes: Sequence[int] | None = None) -> Drawing:
    """Draw the largest changes of each frequency, one panel for each mode.

    - changes: from `pkmodes.loop.sensitivity.changes.changes_at`
    - modes: modes that are drawn, counted from 0; by default all
    """
    shown = range(len(changes.frequencies)) if modes is None else modes
    columns = min(COLUMNS, len(shown))
    rows = -(-len(shown) // columns)
    bars = max(len(_visible(changes, mode)) for mode in shown) + (changes.together is not None)
    height = rows * (BAR * bars + AROUND) + 0.3

    def draw(sheet: Sheet) -> None:
        from matplotlib.layout_engine import ConstrainedLayoutEngine
        from matplotlib.patches import Patch

        sheet.figure.set_layout_engine(ConstrainedLayoutEngine(h_pad=0.08))  # a title is near its own panel
        sheet.groups(len(shown), columns, height)
        for mode, panel in zip(shown, sheet.panels, strict=True):
            _panel(panel, changes, mode, bars)
        step = STEPS[changes.by]
        handles = [
            Patch(label=f"{step} more", facecolor=RISE["color"], edgecolor=BLUE),
            Patch(label=f"{step} less", facecolor=FALL["color"], edgecolor=BLUE),
        ]
        if changes.together is not None:
            handles.append(Patch(label=f"{ALL}: standard deviation", facecolor=GREY, edgecolor=GREY))
        names = [str(handle.get_label()) for handle in handles]
        sheet.legend_of(handles, names, loc="outside upper right", ncols=len(handles))

    return Drawing(draw)


def broken(name: str) -> str:
    """Return a name on lines that are short enough for the space beside a panel."""
    text = visible(name)
    if len(text) <= LONGEST or "." not in text:
        return text
    head, _, last = text.rpartition(".")
    return f"{head}\n.{last}"


def _visible(changes: Changes, mode: int) -> list[int]:
    size = np.abs(changes.changes[:, mode])
    return [i for i in changes.largest(mode, MOST) if size[i] > LEAST * size.max()]


def _panel(panel: Panel, changes: Changes, mode: int, bars: int) -> None:
    axes, largest = panel.axes, _visible(changes, mode)
    names = [", ".join(map(visible, changes.names[i])) for i in largest]
    shown = [",\n".join(map(broken, changes.names[i])) for i in largest]
    style: dict[str, Any] = {"height": 0.66, "linewidth": 0.8}
    step = STEPS[changes.by]
    for place, i in enumerate(largest):
        size = float(changes.changes[i, mode])
        panel.bar(place, 0.0, size, label=f"{step} more", **style, **RISE)
        panel.bar(place, 0.0, -size, label=f"{step} less", **style, **FALL)
    if changes.together is not None:
        size = float(changes.together[mode])
        panel.bar(len(names), -size, size, label=ALL, **style, **TOGETHER)
        names, shown = [*names, ALL], [*shown, ALL]
    panel.axes.axvline(0.0, color=INK, linewidth=0.8)
    panel.name_places("y", range(len(names)), shown, names, fontsize=7, linespacing=0.95)
    axes.set_ylim(bars - 0.4, -0.6)  # the largest on top, bars equally wide in all panels
    axes.tick_params(axis="y", length=0)
    axes.grid(visible=False, axis="y")
    longest = max(
        [float(np.abs(changes.changes[largest, mode]).max(initial=0.0))]
        + ([] if changes.together is None else [float(changes.together[mode])])
    )
    if longest > 0.0:
        axes.set_xlim(-SPACE * longest, SPACE * longest)
    axes.locator_params(axis="x", nbins=5)
    title = f"mode {mode + 1}, {typeset(f'{changes.frequencies[mode]:.2f}')} Hz"
    panel.inner.clear()  # it has a scale of its own
    panel.label(title, x="change of the frequency [Hz]")
