"""Which parameter each frequency depends on: relative sensitivities in a plane."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import one_name_per_line, typeset
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import contrasting_ink

Array = NDArray[Any]
#: Maximum number of parameters listed, and of modes whose columns have room for the word "mode".
MAX_ROWS, MAX_WORDED_COLUMNS = 14, 8


def influence_table(paths: Sequence[str], relative_sensitivities: Array) -> Drawing:
    """Draw the influence of each parameter on each frequency, as the median over the plane.

    It is a median because some sensitivities grow without bound at the edge of a plane.

    - paths: parameters; those with the same effect are one entry, separated by commas
    - relative_sensitivities: d ln f / d ln p, (rows, columns, parameters, modes)
    """
    reachable_values = relative_sensitivities[np.isfinite(relative_sensitivities).all(axis=(2, 3))]
    medians = (
        np.median(reachable_values, axis=0)
        if len(reachable_values)
        else np.zeros(relative_sensitivities.shape[2:])
    )
    order = np.argsort(-np.abs(medians).max(axis=1))[:MAX_ROWS]
    limit = max(float(np.abs(medians).max()), 1e-12)
    modes, names = medians.shape[1], [paths[i] for i in order]

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(0.24 * len(order) + 0.9)
        mesh = panel.image(medians[order], cmap="PuOr", vmin=-limit, vmax=limit, aspect="auto")
        mode_names = [f"mode {i + 1}" for i in range(modes)]
        is_numbered_only = modes > MAX_WORDED_COLUMNS
        titles = [str(i + 1) for i in range(modes)] if is_numbered_only else mode_names
        panel.set_tick_names("x", range(modes), titles, mode_names)
        panel.set_tick_names("y", range(len(order)), [one_name_per_line(name) for name in names], names)
        panel.axes.grid(visible=False)
        panel.axes.tick_params(length=0)
        if is_numbered_only:
            panel.axes.set_xlabel("mode")
        style: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": 6.0 if is_numbered_only else 7.5}
        for (row, mode), value in np.ndenumerate(medians[order]):
            text_colour = contrasting_ink(mesh.to_rgba(value))
            panel.axes.text(mode, row, typeset(f"{value:+.2f}"), color=text_colour, **style)
        sheet.colour_scale(mesh, "d ln f / d ln p, median over the plane [1]", aspect=25)

    return Drawing(draw)
