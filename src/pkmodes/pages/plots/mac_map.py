"""How much mode shapes change between neighbouring poses: their MAC."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.panels import draw_shared_scale, mode_panels
from pkmodes.pages.plots.plane import Plane
from pkmodes.pages.plots.sheet import Sheet

Array = NDArray[Any]
#: MAC above which shapes hardly differ; `pkmodes.machine.maps.tracking` reports veering below 0.9.
GRADUAL_MAC = 0.95


def neighbouring_mac(plane: Plane, mac: Array) -> Drawing | str:
    """Draw the smallest MAC of each mode with the mode of the same number at the neighbouring poses.

    - mac: from `pkmodes.pages.figures.quantities.smallest_mac`, (rows, columns, modes)

    Returns a sentence if it is nearly 1 everywhere.
    """
    if np.isfinite(mac).any() and (smallest := float(np.nanmin(mac))) >= GRADUAL_MAC:
        return (
            "No mode shape changes abruptly: the smallest MAC of a mode with the mode of the same number at a "
            f"neighbouring pose is {np.floor(1e3 * smallest) / 1e3:.3f}."
        )
    space_below = 0.0 if plane.is_tall else 0.5

    def draw(sheet: Sheet) -> None:
        mesh: Any = None
        for mode, panel in mode_panels(sheet, plane, mac.shape[-1], scales="common", space_below=space_below):
            mesh = plane.draw(panel, mac[..., mode], vmin=0.0, vmax=1.0)
        draw_shared_scale(sheet, plane, mesh, "smallest MAC with a neighbouring pose [1]")

    return Drawing(draw)
