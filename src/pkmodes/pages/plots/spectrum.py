"""Frequencies of every setup: measured modes, and the modes of the model, also those that were not measured."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.pages.plots import marks
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import GREEN, GREY

#: Modes of the model are shown up to this multiple of the highest measured frequency.
ABOVE = 1.12
#: Half the length of a line of the model, in setups; then the styles of the first and the last stage.
HALF = 0.36
STYLES = (
    {"color": GREY, "linewidth": 2.6, "alpha": 0.55},
    {"color": GREEN, "linewidth": 1.2},
)
#: Opacity and label of the bands around the lines of the declared model.
SHADE, BAND = 0.25, "\u00b1 \u03c3 as declared"


def spectrum(evidence: PlottedEvidence) -> Drawing:
    """Return the frequencies of all setups: dots are measured, lines are the model.

    Bands are one standard deviation of the declared values on either side of the declared model.
    """

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.9)
        axes = panel.axes
        highest = ABOVE * float(evidence.measured.max())
        for stage, style in zip(evidence.stages, STYLES[-len(evidence.stages) :], strict=True):
            setup, mode = np.nonzero(stage.predicted.elastic_frequencies <= highest)
            y, ends = (
                stage.predicted.elastic_frequencies[setup, mode],
                np.stack([setup - HALF, setup + HALF], axis=1),
            )
            rasterized, label = len(y) > marks.RASTERIZE_ABOVE, f"model {stage.title}"
            panel.lines(ends, y[:, None], label=label, zorder=2, rasterized=rasterized, **style)
        if evidence.spread is not None:
            _bands(panel, evidence.stages[0].predicted.elastic_frequencies, evidence.spread, highest)
        position = evidence.setup.astype(float)
        paired = evidence.mode() > 0
        marks.mark_rows(panel, evidence, np.where(paired, position, np.nan), evidence.measured)
        if not paired.all():
            panel.scatter(
                position[~paired],
                evidence.measured[~paired],
                s=26,
                linewidth=1.3,
                zorder=4,
                **marks.UNMATCHED_STYLE,
            )
        axes.set_ylim(0.0, highest)
        axes.set_xlim(-0.7, len(evidence.labels) - 0.3)
        panel.label(x=marks.label_setups(panel, evidence), y="frequency [Hz]")
        marks.add_legend(sheet, panel)

    return Drawing(draw)


def _bands(panel: Panel, spectrum: NDArray[np.float64], spread: NDArray[np.float64], highest: float) -> None:
    """Shade one standard deviation on either side of the lines of the declared model."""
    from matplotlib.collections import PolyCollection

    modes = min(spectrum.shape[1], spread.shape[1])  # modes that pad a setup are in neither
    y, sigma = spectrum[:, :modes], spread[:, :modes]
    setup, mode = np.nonzero((y <= highest) & (sigma > 0.0))
    if not len(setup):
        return
    low, high = (y[setup, mode] + side * sigma[setup, mode] for side in (-1.0, 1.0))
    corners = [(setup - HALF, low), (setup + HALF, low), (setup + HALF, high), (setup - HALF, high)]
    boxes = np.stack([np.stack(corner, axis=-1) for corner in corners], axis=1)
    rasterized = len(setup) > marks.RASTERIZE_ABOVE
    bands = PolyCollection(
        list(boxes), facecolor=GREY, alpha=SHADE, linewidth=0, zorder=1, rasterized=rasterized, label=BAND
    )
    panel.axes.add_collection(bands, autolim=False)
    panel.limits(setup, low, high, BAND)
