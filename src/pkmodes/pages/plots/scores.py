"""The scores of the candidates, and the shifts of uncertain values by the fit."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from pkmodes.loop.diagnosis.verdict.findings import Corrected, Examined
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.pages.plots import marks
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import short_label, visible_text
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREEN, GREY, INK, PAPER

#: Maximum number of candidates or values in a figure, and maximum length of a name.
MAX_ROWS, MAX_NAME_LENGTH = 16, 64
#: Maximum length of a row label: a description and a name.
MAX_LABEL_LENGTH = 96
#: Height of a row with its label [inch]; distance of the label above the line, as a fraction of a row.
ROW_HEIGHT, LABEL_OFFSET = 0.3, 0.12
#: Fraction of the axis left of 0, so that a mark at 0 is not cut off.
LEFT_MARGIN = 0.012
#: Smaller p-values are beyond the axis: a little below, floating-point numbers underflow to 0.
MIN_P_VALUE = 1e-300
BEYOND_LABEL, MAX_SCORE = "beyond 300", 300.0


def candidate_scores(result: Diagnosis) -> Drawing | None:
    """Draw the scores of the candidates, the most significant first; None if none was tested."""
    candidates = sorted(result.candidates, key=lambda candidate: candidate.p_value)[:MAX_ROWS]
    if not candidates:
        return None
    claimed_names = {name for effect in result.effects for name in effect.members}
    remaining_names = {
        name for group in result.survivors for explanation in group for name in explanation.split(" + ")
    }
    other_names = {candidate.name for candidate in candidates} - claimed_names - remaining_names
    categories = (
        ("claimed, with its class", BLUE, claimed_names),
        ("remains", GREEN, remaining_names - claimed_names),
        ("not claimed", GREY, other_names),
    )

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(0.85 + ROW_HEIGHT * len(candidates))
        rows_beyond = [candidates.index(candidate) for candidate in candidates if is_beyond_axis(candidate)]
        if rows_beyond:
            mark_style: dict[str, Any] = {"marker": ">", "s": 34, "linewidth": 1.2, "zorder": 3}
            panel.lines(
                np.array([[0.0, MAX_SCORE]] * len(rows_beyond)),
                np.array(rows_beyond)[:, None],
                color=INK,
                linewidth=1.6,
            )
            panel.scatter(
                [MAX_SCORE] * len(rows_beyond), rows_beyond, color=INK, label=BEYOND_LABEL, **mark_style
            )
        for label, colour, names in categories:
            for detectable, face_colour in ((True, colour), (False, PAPER)):
                drawn_candidates = [
                    candidate
                    for candidate in candidates
                    if candidate.name in names
                    and candidate.detectable == detectable
                    and not is_beyond_axis(candidate)
                ]
                if drawn_candidates:
                    y = np.array([candidates.index(candidate) for candidate in drawn_candidates])
                    x = -np.log10([candidate.p_value for candidate in drawn_candidates])
                    ends = np.stack([0.0 * x, x], axis=1)[x > 0.0]
                    panel.lines(ends, y[x > 0.0, None], color=colour, linewidth=1.6)
                    name = label if detectable else f"{label}, not detectable"
                    panel.scatter(
                        x,
                        y,
                        s=22,
                        facecolor=face_colour,
                        edgecolor=colour,
                        linewidth=1.2,
                        zorder=3,
                        label=name,
                    )
        _name_rows(panel, [_row_label(candidate.sentence, candidate.name) for candidate in candidates])
        axis_end = panel.axes.get_xlim()[1]
        panel.axes.set_xlim(-LEFT_MARGIN * axis_end, axis_end)
        panel.label(x="score: \u2212log\u2081\u2080 of the p-value of this candidate alone [1]")
        marks.add_legend(sheet, panel)

    return Drawing(draw)


def is_beyond_axis(candidate: Examined) -> bool:
    """Return whether the p-value is too small for the axis."""
    return candidate.p_value < MIN_P_VALUE


def _row_label(description: str, name: str) -> str:
    """Return the label of a row: the description with the name, or only the name if the description does not fit.

    A description is never shortened; the table below the figure has all of them.
    """
    short_name = short_label(name.removeprefix("effects."), MAX_NAME_LENGTH)
    text = visible_text(description)
    return (
        f"{text} ({short_name})"
        if text and len(text) <= max(MAX_LABEL_LENGTH - len(short_name), MAX_NAME_LENGTH)
        else short_name
    )


def _name_rows(panel: Panel, labels: Sequence[str]) -> None:
    """Label the rows, each above its line, so that lines have the full width on a small screen too."""
    axes = panel.axes
    panel.set_tick_names("y", [i - LABEL_OFFSET for i in range(len(labels))], labels)
    axes.set_ylim(len(labels) - 0.5, -0.9)
    axes.tick_params(axis="y", length=0.0, pad=-3.0)
    for text in axes.get_yticklabels():
        text.set(horizontalalignment="left", verticalalignment="bottom")
    axes.grid(visible=False, axis="y")


def shifts_from_prior(
    values: Sequence[Corrected], describe: Callable[[str], str] | None = None
) -> Drawing | None:
    """Draw how far the fit moved each value, in standard deviations of its prior; None if none has a prior.

    The bars are the standard deviations of the table, which include the effect of candidates that were not observed.

    - describe: function that returns a description for the name of a value, or an empty text
    """
    with_prior = [(value, value.prior_sigma) for value in values if value.prior_sigma]
    shifts = [
        ((value.value - value.declared) / prior_sigma, value.saved_sigma / prior_sigma, value.name)
        for value, prior_sigma in with_prior
    ]
    largest_shifts = sorted(shifts, key=lambda row: -abs(row[0]))[:MAX_ROWS]
    if not largest_shifts:
        return None
    labels = [_row_label(describe(name) if describe else "", name) for _, _, name in largest_shifts]
    shift_values, widths, _ = zip(*largest_shifts, strict=True)

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(0.8 + ROW_HEIGHT * len(labels))
        axes = panel.axes
        axes.axvspan(-1.0, 1.0, color=GREY, alpha=0.16, linewidth=0, label="prior, \u00b11 \u03c3")
        marks.draw_vertical_zero_line(panel)
        panel.error_bars(
            shift_values,
            range(len(largest_shifts)),
            widths,
            fmt="o",
            color=BLUE,
            capsize=2.5,
            label="after the fit, \u00b11 \u03c3",
        )
        _name_rows(panel, labels)
        limit = max(3.0, *(abs(shift) + width for shift, width, _ in largest_shifts)) * 1.05
        axes.set_xlim(-limit, limit)
        axes.grid(visible=False, axis="y")
        panel.label(x="value \u2212 declared value [\u03c3 of the prior]")
        marks.add_legend(sheet, panel)

    return Drawing(draw)
