"""Differences of the model from the measurements: by mode, by setup, and against the components of the pose."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pkmodes.plots import marks
from pkmodes.plots.evidence import Evidence
from pkmodes.plots.labels import short
from pkmodes.plots.style import INK, figure, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Width in which the setups of a mode are spread, in modes, and half the length of the line of their median.
SPREAD, HALF = 0.6, 0.34
#: Space beyond the largest differences, relative to their range.
MARGIN = 0.07
#: Most modes whose typical frequency is written below their number.
MOST_NAMED = 12
SIGMAS = "difference [\u03c3]"


def by_mode(evidence: Evidence) -> Figure:
    """Return the relative differences of each mode's setups, one panel for each stage, on one scale."""
    mode = evidence.mode()
    place = mode + SPREAD * ((evidence.setup + 0.5) / len(evidence.labels) - 0.5)
    with styled():
        stages = evidence.stages
        drawn = figure(0.7 + 1.75 * len(stages))
        panels = drawn.subplots(len(stages), 1, sharex=True, sharey=True, squeeze=False)[:, 0]
        for axes, stage in zip(panels, stages, strict=True):
            percent = 100.0 * evidence.difference(stage)
            marks.zero(axes)
            marks.rows(axes, evidence, np.where(mode > 0, place, np.nan), percent)
            for one in range(1, evidence.modes + 1):
                some = percent[(mode == one) & ~evidence.outlier & np.isfinite(percent)]
                if len(some):
                    axes.hlines(np.median(some), one - HALF, one + HALF, color=INK, linewidth=1.2, zorder=2)
            axes.set_title(f"Model {stage.title}")
            axes.set_ylabel("difference [%]")
            axes.grid(visible=False, axis="x")
        shown = 100.0 * np.hstack([evidence.difference(stage)[stage.paired] for stage in stages])
        low, high = float(shown.min(initial=0.0)), float(shown.max(initial=0.0))
        panels[0].set_ylim(low - MARGIN * (high - low), high + MARGIN * (high - low))
        marks.legend(panels[0])
        panels[-1].set_xticks(range(1, evidence.modes + 1), _names(evidence))
        panels[-1].set_xlim(0.45, evidence.modes + 0.55)
        panels[-1].set_xlabel("mode of the model, with the median of its measured frequencies")
    return drawn


def _names(evidence: Evidence) -> list[str]:
    """Return the numbers of the modes, with their typical frequency if there is room."""
    mode, names = evidence.mode(), []
    for one in range(1, evidence.modes + 1):
        some = evidence.measured[mode == one]
        typical = f"\n{np.median(some):.3g} Hz" if len(some) and evidence.modes <= MOST_NAMED else ""
        names.append(f"{one}{typical}")
    return names


def by_setup(evidence: Evidence) -> Figure:
    """Return the differences at each setup in standard deviations, one panel for each stage."""
    with styled():
        stages = evidence.stages
        drawn = figure(0.8 + 1.75 * len(stages))
        panels = drawn.subplots(len(stages), 1, sharex=True, squeeze=False)[:, 0]
        for axes, stage in zip(panels, stages, strict=True):
            marks.noise(axes, stage.predicted.sigmas)
            marks.zero(axes)
            marks.rows(axes, evidence, evidence.setup.astype(float), stage.predicted.sigmas)
            axes.set_title(f"Model {stage.title}")
            axes.set_ylabel(SIGMAS)
        marks.legend(panels[0])
        panels[-1].set_xlim(-0.7, len(evidence.labels) - 0.3)
        marks.setups(panels[-1], evidence)
    return drawn


def varying_components(evidence: Evidence) -> list[int]:
    """Return the components of the pose that differ between setups."""
    return [k for k in range(len(evidence.components)) if np.ptp(evidence.points[:, k]) > 0.0]


def against_pose(evidence: Evidence) -> Figure | None:
    """Return the differences against each component of the pose that varies; None if none does."""
    varying = varying_components(evidence)
    count = len(varying)
    if not count:
        return None
    with styled():
        stages = evidence.stages
        drawn = figure(0.7 + 1.75 * len(stages))
        panels = drawn.subplots(len(stages), count, sharex="col", sharey="row", squeeze=False)
        for row, stage in zip(panels, stages, strict=True):
            for k, axes in zip(varying, row, strict=True):
                marks.noise(axes, stage.predicted.sigmas)
                marks.zero(axes)
                place = evidence.points[evidence.setup, k]
                marks.rows(axes, evidence, place, stage.predicted.sigmas, size=12.0)
                axes.locator_params(axis="x", nbins=3)
            row[0].set_title(f"Model {stage.title}")
            row[0].set_ylabel(SIGMAS)
        for k, axes in zip(varying, panels[-1], strict=True):
            axes.set_xlabel(short(f"{evidence.components[k]} [{evidence.units[k]}]"))
        marks.legend(panels[0, -1], beside=count > 1)
    return drawn
