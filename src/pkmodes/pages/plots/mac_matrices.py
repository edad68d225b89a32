"""MAC matrices: how similar each measured shape is to each mode of the model."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.evidence import ModelStage, PlottedEvidence
from pkmodes.pages.plots.labels import short_label
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet

Array = NDArray[np.float64]
#: Maximum number of modes for which the numbers are written into the cells.
MAX_WRITTEN_MODES = 8
#: MAC above which a cell is so light that its number is dark.
LIGHT_CELL_MAC = 0.55


def worst_setup(evidence: PlottedEvidence) -> int | None:
    """Return the setup with the lowest MAC of a paired mode at the last stage; None without shapes."""
    mac = evidence.last_stage.predicted.partner_mac
    if not np.isfinite(mac).any():
        return None
    return int(evidence.setup_indices[int(np.nanargmin(mac))])


def mac_matrices(evidence: PlottedEvidence) -> Drawing | None:
    """Draw MAC matrices, the mean over all setups and the setup with the lowest MAC; None without shapes.

    Rows are the measured modes, numbered as their partners at the last stage.
    """
    worst = worst_setup(evidence)
    if worst is None:
        return None
    stages, has_several_setups = evidence.stages, len(evidence.labels) > 1
    label = short_label(evidence.labels[worst])
    all_rows = np.ones(len(evidence.setup_indices), dtype=bool)
    selections = [(f"mean of all {evidence.setup_noun}s", all_rows)] if has_several_setups else []
    selections.append((f"lowest MAC: {label}", evidence.setup_indices == worst))

    def draw(sheet: Sheet) -> None:
        height = 0.6 + min(2.55, 1.0 + 0.3 * evidence.mode_count) * len(selections)
        rows, count = (1.0,) * len(selections), len(stages)
        groups = sheet.groups(count, count, height, rows=rows, height_to_width=1.0, scales="common")
        image: Any = None
        for panels, stage in zip(groups, stages, strict=True):
            for panel, (name, selected) in zip(panels, selections, strict=True):
                image = draw_matrix(panel, mean_mac_matrix(evidence, stage, selected))
                title, x_label = f"Model {stage.title}", "mode of the model"
                panel.label(title, x=x_label, y="measured mode", row=name)
        sheet.colour_scale(image, "MAC [1]", shrink=0.7, aspect=30)

    return Drawing(draw)


def mean_mac_matrix(evidence: PlottedEvidence, stage: ModelStage, selected: NDArray[np.bool_]) -> Array:
    """Return the mean MAC of measured modes (rows) and modes of the model, (M, M), NaN where there is no shape."""
    mode, count = evidence.mode_numbers(), evidence.mode_count
    macs = stage.predicted.mac_by_mode
    mean_mac = np.full((count, count), np.nan)
    for number in range(1, count + 1):
        rows = selected & (mode == number) & np.isfinite(macs).any(axis=1)
        if rows.any():
            mean = macs[rows].mean(axis=0)[:count]
            mean_mac[number - 1, : len(mean)] = mean
    return mean_mac


def draw_matrix(panel: Panel, values: Array) -> Any:
    """Draw a matrix of MACs (M, M), its modes numbered from 1; the cells of a small one show their values."""
    axes, count = panel.axes, len(values)
    modes = np.arange(1.0, count + 1)
    image = panel.cells(modes, modes, values, vmin=0.0, vmax=1.0)
    axes.set_aspect("equal")
    axes.invert_yaxis()
    axes.grid(visible=False)
    ticks = range(1, count + 1, 1 if count <= MAX_WRITTEN_MODES else 5)
    axes.set_xticks(ticks)
    axes.set_yticks(ticks)
    for i, k in np.argwhere(np.isfinite(values)) if count <= MAX_WRITTEN_MODES else ():
        is_light_cell = values[i, k] > LIGHT_CELL_MAC
        axes.text(
            k + 1,
            i + 1,
            f"{values[i, k]:.2f}",
            ha="center",
            va="center",
            fontsize=7,
            color="black" if is_light_cell else "white",
        )
    return image
