"""Maps of the difference between the frequencies of two robots."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.panels import mode_panels
from pkmodes.pages.plots.plane import Plane
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLACK

Array = NDArray[Any]
#: Fraction of the largest values that lie beyond the colour scale: those next to singularities.
OUTLIER_FRACTION = 0.02
#: Blue for lower, red for higher frequencies, white for no change; safe for colour-blind readers.
COLOUR_MAP = "RdBu_r"


def relative_changes(plane: Plane, relative_differences: Array) -> Drawing:
    """Draw the relative difference of each mode's frequency in a plane, all on one scale that is symmetric about 0.

    A contour marks the poses without a difference.

    - plane: of the first robot
    - relative_differences: frequency of the second robot over that of the first, minus 1, (rows, columns, modes);
      NaN where one of them has none
    """
    limit = colour_scale_limit(relative_differences)

    def draw(sheet: Sheet) -> None:
        mesh: Any = None
        for mode, panel in mode_panels(sheet, plane, relative_differences.shape[-1], scales="common"):
            values = 100.0 * relative_differences[..., mode]
            mesh = plane.draw(panel, values, vmin=-limit, vmax=limit, cmap=COLOUR_MAP)
            finite = values[np.isfinite(values)]
            if len(finite) and finite.min() < 0.0 < finite.max():
                x, y = plane.display_values(plane.abscissa), plane.display_values(plane.ordinate)
                panel.axes.contour(x, y, np.ma.masked_invalid(values), [0.0], colors=BLACK, linewidths=0.6)
        label = "difference of the frequency [%]"
        sheet.colour_scale(mesh, label, location="right", shrink=0.9, aspect=35, extend="both")

    return Drawing(draw)


def colour_scale_limit(relative_differences: Array) -> float:
    """Return the upper end of the colour scale [%]; `OUTLIER_FRACTION` of the magnitudes lie beyond it."""
    magnitudes = np.abs(relative_differences[np.isfinite(relative_differences)])
    return (
        max(100.0 * float(np.quantile(magnitudes, 1.0 - OUTLIER_FRACTION)), 1e-3) if len(magnitudes) else 1.0
    )
