"""Frequencies at every setup: measured modes, and the modes of the model, including modes not measured."""

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
MAX_FREQUENCY_RATIO = 1.12
#: Half the length of a line of the model, in units of the distance between setups; then the line styles of the first
#: and the last stage.
LINE_HALF_LENGTH = 0.36
STAGE_STYLES = (
    {"color": GREY, "linewidth": 2.6, "alpha": 0.55},
    {"color": GREEN, "linewidth": 1.2},
)
#: Opacity and label of the bands around the lines of the declared model.
BAND_OPACITY, BAND_LABEL = 0.25, "\u00b1 \u03c3 as declared"


def setup_frequencies(evidence: PlottedEvidence) -> Drawing:
    """Draw the frequencies at all setups: dots are measured, lines are the model.

    Bands: one standard deviation of the declared model's frequencies, propagated from those of the declared values.
    """

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.9)
        axes = panel.axes
        highest = MAX_FREQUENCY_RATIO * float(evidence.measured.max())
        for stage, style in zip(evidence.stages, STAGE_STYLES[-len(evidence.stages) :], strict=True):
            setup, mode = np.nonzero(stage.predicted.elastic_frequencies <= highest)
            y, ends = (
                stage.predicted.elastic_frequencies[setup, mode],
                np.stack([setup - LINE_HALF_LENGTH, setup + LINE_HALF_LENGTH], axis=1),
            )
            rasterized, label = len(y) > marks.RASTERIZE_ABOVE, f"model {stage.title}"
            panel.lines(ends, y[:, None], label=label, zorder=2, rasterized=rasterized, **style)
        if evidence.frequency_sigma is not None:
            _shade_bands(
                panel, evidence.stages[0].predicted.elastic_frequencies, evidence.frequency_sigma, highest
            )
        setup_positions = evidence.setup_indices.astype(float)
        has_partner = evidence.mode_numbers() > 0
        marks.mark_rows(panel, evidence, np.where(has_partner, setup_positions, np.nan), evidence.measured)
        if not has_partner.all():
            panel.scatter(
                setup_positions[~has_partner],
                evidence.measured[~has_partner],
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


def _shade_bands(
    panel: Panel, frequencies: NDArray[np.float64], frequency_sigma: NDArray[np.float64], highest: float
) -> None:
    """Shade one standard deviation on either side of the lines of the declared model."""
    from matplotlib.collections import PolyCollection

    mode_count = min(frequencies.shape[1], frequency_sigma.shape[1])  # modes in both; padding is NaN
    y, sigma = frequencies[:, :mode_count], frequency_sigma[:, :mode_count]
    setup, mode = np.nonzero((y <= highest) & (sigma > 0.0))
    if not len(setup):
        return
    low, high = (y[setup, mode] + side * sigma[setup, mode] for side in (-1.0, 1.0))
    corners = [
        (setup - LINE_HALF_LENGTH, low),
        (setup + LINE_HALF_LENGTH, low),
        (setup + LINE_HALF_LENGTH, high),
        (setup - LINE_HALF_LENGTH, high),
    ]
    boxes = np.stack([np.stack(corner, axis=-1) for corner in corners], axis=1)
    rasterized = len(setup) > marks.RASTERIZE_ABOVE
    bands = PolyCollection(
        list(boxes),
        facecolor=GREY,
        alpha=BAND_OPACITY,
        linewidth=0,
        zorder=1,
        rasterized=rasterized,
        label=BAND_LABEL,
    )
    panel.axes.add_collection(bands, autolim=False)
    panel.keep_band_limits(setup, low, high, BAND_LABEL)
