"""What changed between two measurements: the relative change of each mode, with its standard deviation."""

from __future__ import annotations

from typing import Any

import numpy as np

from pkmodes.loop.measured.comparison import MeasurementsCompared
from pkmodes.pages.plots import marks
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, PAPER, VERMILLION


def changes_of_modes(result: MeasurementsCompared) -> Drawing:
    """Draw the relative change of each pair of modes over its frequency in the first measurement.

    Bars are one standard deviation on either side.
    """
    pairs = result.pairs
    f = np.array([pair.first for pair in pairs])
    change = 100.0 * np.array([pair.relative for pair in pairs])
    sigma = 100.0 * np.array([np.hypot(pair.first_sigma, pair.second_sigma) / pair.first for pair in pairs])
    is_significant = np.array([pair.differs for pair in pairs], dtype=bool)
    common_change = result.common.relative if result.common is not None and result.common.differs else None

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(2.8)
        marks.draw_zero_line(panel)
        if common_change is not None:
            line_style: dict[str, Any] = {
                "color": GREY,
                "linestyle": "--",
                "linewidth": 1.0,
                "label": "common change",
            }
            panel.plot([f.min(), f.max()], [100.0 * common_change] * 2, **line_style)
        for selected, colour, face_colour, label in (
            (is_significant, VERMILLION, VERMILLION, "changed"),
            (~is_significant, BLUE, PAPER, "within the errors"),
        ):
            if not selected.any():
                continue
            ends = np.stack([change - sigma, change + sigma], axis=1)[selected]
            panel.lines(f[selected, None], ends, color=colour, linewidth=1.2)
            mark_style: dict[str, Any] = {
                "s": 22,
                "facecolor": face_colour,
                "edgecolor": colour,
                "linewidth": 1.2,
                "zorder": 3,
            }
            panel.scatter(f[selected], change[selected], label=label, **mark_style)
        panel.label(x="frequency in the first [Hz]", y="change [%]")
        marks.add_legend(sheet, panel)

    return Drawing(draw)
