"""Frequencies of every setup: measured modes, and the modes of the model, also those that were not measured."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.plots import marks
from pkmodes.plots.evidence import Evidence
from pkmodes.plots.style import GREEN, GREY, figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Modes of the model are shown up to this multiple of the highest measured frequency.
ABOVE = 1.12
#: Half the length of a model's line, in setups, and the styles of the first and the last stage.
HALF = 0.36
STYLES = (
    {"color": GREY, "linewidth": 2.6, "alpha": 0.55},
    {"color": GREEN, "linewidth": 1.2},
)


def spectrum(evidence: Evidence) -> Figure:
    """Return the frequencies of all setups: dots are measured, lines are the model."""
    with styled():
        drawn = figure(3.9)
        axes = drawn.subplots()
        most = ABOVE * float(evidence.measured.max())
        for stage, style in zip(evidence.stages, STYLES[-len(evidence.stages) :], strict=True):
            _lines(axes, stage.predicted.spectrum, most, f"model {stage.title}", style)
        place = evidence.setup.astype(float)
        paired = evidence.mode() > 0
        marks.rows(axes, evidence, np.where(paired, place, np.nan), evidence.measured)
        if not paired.all():
            axes.scatter(
                place[~paired], evidence.measured[~paired], s=26, linewidth=1.3, zorder=4, **marks.UNMATCHED
            )
        axes.set_ylim(0.0, most)
        axes.set_xlim(-0.7, len(evidence.labels) - 0.3)
        axes.set_ylabel("frequency [Hz]")
        marks.setups(axes, evidence)
        marks.legend(axes)
    return drawn


def _lines(axes: Axes, spectrum: NDArray[np.float64], most: float, label: str, style: dict[str, Any]) -> None:
    """Draw a short line for each mode of each setup."""
    setup, mode = np.nonzero(spectrum <= most)
    y = spectrum[setup, mode]
    axes.hlines(y, setup - HALF, setup + HALF, label=label, zorder=2, rasterized=len(y) > marks.MANY, **style)
