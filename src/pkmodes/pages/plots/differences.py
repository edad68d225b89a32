"""Differences of the model from the measurements: by mode, by setup, and against the components of the pose."""

from __future__ import annotations

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.pages.plots import marks
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.labels import short_label
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import INK

#: Width over which the setups of a mode are spread, and half the length of the median line, both in modes.
MODE_WIDTH, MEDIAN_HALF_LENGTH = 0.6, 0.34
#: Margin beyond the largest differences, relative to their range.
AXIS_MARGIN = 0.07
#: Maximum number of modes for which the median frequencies are written below the mode numbers.
MAX_MODES_WITH_FREQUENCY = 12
SIGMA_LABEL = "difference [\u03c3]"


def by_mode(evidence: PlottedEvidence) -> Drawing:
    """Draw the relative differences at the setups of each mode, one panel for each stage, on one scale."""
    modes, stages = evidence.mode_numbers(), evidence.stages
    position = modes + MODE_WIDTH * ((evidence.setup_indices + 0.5) / len(evidence.labels) - 0.5)
    numbers, names = range(1, evidence.mode_count + 1), []
    for number in numbers:  # with their median frequencies if there is room
        values_of_mode = evidence.measured[modes == number]
        frequency_line = (
            f"\n{plain(np.median(values_of_mode), 3)} Hz"
            if len(values_of_mode) and evidence.mode_count <= MAX_MODES_WITH_FREQUENCY
            else ""
        )
        names.append(f"{number}{frequency_line}")

    def draw(sheet: Sheet) -> None:
        sheet.groups(len(stages), 1, 0.7 + 1.75 * len(stages), share_x=True, share_y=True)
        for panel, stage in zip(sheet.panels, stages, strict=True):
            differences_percent = 100.0 * evidence.difference(stage)
            marks.draw_zero_line(panel)
            marks.mark_rows(panel, evidence, np.where(modes > 0, position, np.nan), differences_percent)
            for number in numbers:
                values_of_mode = differences_percent[
                    (modes == number) & ~evidence.outlier & np.isfinite(differences_percent)
                ]
                if len(values_of_mode):
                    ends = np.array([[number - MEDIAN_HALF_LENGTH, number + MEDIAN_HALF_LENGTH]])
                    panel.lines(ends, np.median(values_of_mode), color=INK, linewidth=1.2, zorder=2)
            panel.label(
                f"Model {stage.title}",
                x="mode of the model, with the median of its measured frequencies",
                y="difference [%]",
            )
            panel.set_tick_names("x", numbers, names)
            panel.axes.grid(visible=False, axis="x")
        all_differences = 100.0 * np.hstack([evidence.difference(stage)[stage.paired] for stage in stages])
        low, high = float(all_differences.min(initial=0.0)), float(all_differences.max(initial=0.0))
        panel.axes.set_ylim(low - AXIS_MARGIN * (high - low), high + AXIS_MARGIN * (high - low))
        panel.axes.set_xlim(0.45, evidence.mode_count + 0.55)
        marks.add_legend(sheet, sheet.panels[0])

    return Drawing(draw)


def by_setup(evidence: PlottedEvidence) -> Drawing:
    """Draw the differences at each setup in standard deviations, one panel for each stage."""
    stages = evidence.stages

    def draw(sheet: Sheet) -> None:
        sheet.groups(len(stages), 1, 0.8 + 1.75 * len(stages), share_x=True)
        for panel, stage in zip(sheet.panels, stages, strict=True):
            marks.shade_noise_band(panel, stage.predicted.normalised_differences)
            marks.draw_zero_line(panel)
            marks.mark_rows(
                panel, evidence, evidence.setup_indices.astype(float), stage.predicted.normalised_differences
            )
            setup_label = marks.label_setups(panel, evidence, grid=panel is not sheet.panels[-1])
            panel.label(f"Model {stage.title}", x=setup_label, y=SIGMA_LABEL)
        panel.axes.set_xlim(-0.7, len(evidence.labels) - 0.3)
        marks.add_legend(sheet, sheet.panels[0])

    return Drawing(draw)


def varying_components(evidence: PlottedEvidence) -> list[int]:
    """Return the components of the pose that differ between setups."""
    return [k for k in range(len(evidence.components)) if np.ptp(evidence.poses[:, k]) > 0.0]


def against_pose(evidence: PlottedEvidence) -> Drawing | None:
    """Draw the differences against each component of the pose that varies; None if none does."""
    component_indices, stages = varying_components(evidence), evidence.stages
    count = len(component_indices)
    if not count:
        return None

    def draw(sheet: Sheet) -> None:
        height = 0.7 + 1.75 * len(stages)
        sheet.groups(count * len(stages), count, height, share_x="col", share_y="row")
        for panel_number, panel in enumerate(sheet.panels):
            row, column = divmod(panel_number, count)
            stage, k = stages[row], component_indices[column]
            marks.shade_noise_band(panel, stage.predicted.normalised_differences)
            marks.draw_zero_line(panel)
            position = evidence.poses[evidence.setup_indices, k]
            marks.mark_rows(panel, evidence, position, stage.predicted.normalised_differences, size=12.0)
            panel.axes.locator_params(axis="x", nbins=3)
            if column:  # the panels of a stage stand side by side
                panel.omitted_labels.add("title")
            panel.label(
                f"Model {stage.title}",
                x=short_label(f"{evidence.components[k]} [{evidence.units[k]}]"),
                y=SIGMA_LABEL,
            )
        marks.add_legend(sheet, sheet.panels[count - 1], may_extend_left=count > 1)

    return Drawing(draw)
