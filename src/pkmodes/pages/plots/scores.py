"""Candidates with their scores, and uncertain values with how far the fit moved them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from pkmodes.loop.diagnosis.verdict.findings import Corrected, Examined
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.pages.plots import marks
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import short, visible
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREEN, GREY, INK, PAPER

#: Most candidates or values in a figure, and length of the longest name.
MOST, LONGEST = 16, 64
#: Length of the longest row label: words and a name.
WHOLE = 96
#: Height of a row with its label [inch]; the label is this fraction of a row above the line.
ROW, ABOVE = 0.3, 0.12
#: Fraction of the axis left of 0, so that a mark at 0 is not cut off.
LEFT = 0.012
#: Smaller p-values are beyond the axis: below it a computer soon holds 0 alone.
LEAST = 1e-300
BEYOND, LIMIT = "beyond 300", 300.0


def candidate_scores(result: Diagnosis) -> Drawing | None:
    """Return the scores of the candidates, the most significant first; None if none was tested."""
    candidates = sorted(result.candidates, key=lambda candidate: candidate.p_value)[:MOST]
    if not candidates:
        return None
    claimed = {name for effect in result.effects for name in effect.members}
    remaining = {
        name for group in result.survivors for explanation in group for name in explanation.split(" + ")
    }
    kinds = [
        ("claimed, with its class", BLUE, [c for c in candidates if c.name in claimed]),
        ("remains", GREEN, [c for c in candidates if c.name in remaining - claimed]),
        ("not claimed", GREY, [c for c in candidates if c.name not in claimed | remaining]),
    ]

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(0.85 + ROW * len(candidates))
        beyond = [candidates.index(c) for c in candidates if is_beyond(c)]
        if beyond:
            marks_beyond: dict[str, Any] = {"marker": ">", "s": 34, "linewidth": 1.2, "zorder": 3}
            panel.lines(
                np.array([[0.0, LIMIT]] * len(beyond)), np.array(beyond)[:, None], color=INK, linewidth=1.6
            )
            panel.scatter([LIMIT] * len(beyond), beyond, color=INK, label=BEYOND, **marks_beyond)
        for label, colour, group in kinds:
            for detectable, face in ((True, colour), (False, PAPER)):
                plotted = [c for c in group if c.detectable == detectable and not is_beyond(c)]
                if plotted:
                    y = np.array([candidates.index(c) for c in plotted])
                    x = -np.log10([c.p_value for c in plotted])
                    ends = np.stack([0.0 * x, x], axis=1)[x > 0.0]
                    panel.lines(ends, y[x > 0.0, None], color=colour, linewidth=1.6)
                    name = label if detectable else f"{label}, not detectable"
                    panel.scatter(
                        x, y, s=22, facecolor=face, edgecolor=colour, linewidth=1.2, zorder=3, label=name
                    )
        _rows(panel, [_label(candidate.sentence, candidate.name) for candidate in candidates])
        end = panel.axes.get_xlim()[1]
        panel.axes.set_xlim(-LEFT * end, end)
        panel.label(x="score: \u2212log\u2081\u2080 of the p-value of this candidate alone [1]")
        marks.add_legend(sheet, panel)

    return Drawing(draw)


def is_beyond(candidate: Examined) -> bool:
    """Return whether the p-value is too small for the axis."""
    return candidate.p_value < LEAST


def _label(words: str, name: str) -> str:
    """Return the label of a row: in words, and the name after them; the name alone where the words do not fit.

    Words are not cut; the table below the figure has them whole.
    """
    short_name = short(name.removeprefix("effects."), LONGEST)
    text = visible(words)
    return (
        f"{text} ({short_name})"
        if text and len(text) <= max(WHOLE - len(short_name), LONGEST)
        else short_name
    )


def _rows(panel: Panel, labels: Sequence[str]) -> None:
    """Name the rows, each above its line, so that the lines have the whole width, also on a small screen."""
    axes = panel.axes
    panel.name_places("y", [i - ABOVE for i in range(len(labels))], labels)
    axes.set_ylim(len(labels) - 0.5, -0.9)
    axes.tick_params(axis="y", length=0.0, pad=-3.0)
    for text in axes.get_yticklabels():
        text.set(horizontalalignment="left", verticalalignment="bottom")
    axes.grid(visible=False, axis="y")


def pulls(values: Sequence[Corrected], words: Callable[[str], str] | None = None) -> Drawing | None:
    """Return how far the fit moved each value, in standard deviations of its prior; None if none has a prior.

    The bars are the standard deviations of the table, which include what was not observed.

    - words: returns what the name of a value means, or nothing
    """
    with_prior = [(value, value.prior_sigma) for value in values if value.prior_sigma]
    shifts = [((v.value - v.declared) / prior, v.saved_sigma / prior, v.name) for v, prior in with_prior]
    largest_shifts = sorted(shifts, key=lambda entry: -abs(entry[0]))[:MOST]
    if not largest_shifts:
        return None
    labels = [_label(words(name) if words else "", name) for _, _, name in largest_shifts]
    shift_values, widths, _ = zip(*largest_shifts, strict=True)

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(0.8 + ROW * len(labels))
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
        _rows(panel, labels)
        limit = max(3.0, *(abs(a) + w for a, w, _ in largest_shifts)) * 1.05
        axes.set_xlim(-limit, limit)
        axes.grid(visible=False, axis="y")
        panel.label(x="value \u2212 declared value [\u03c3 of the prior]")
        marks.add_legend(sheet, panel)

    return Drawing(draw)
