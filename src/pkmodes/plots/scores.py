"""Candidates with their scores, and uncertain values with how far the fit moved them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pkmodes.diagnosis.verdict.result import Corrected, Diagnosis
from pkmodes.plots import marks
from pkmodes.plots.labels import short
from pkmodes.plots.style import BLUE, GREEN, GREY, figure, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Most candidates or values in a figure, and their longest name.
MOST, LONGEST = 24, 40
#: Smallest p-value that is distinguished from 0.
LEAST = 1e-300


def candidates(result: Diagnosis) -> Figure | None:
    """Return the scores of the candidates, the most significant first; None if none was tested."""
    tested = sorted(result.candidates, key=lambda one: one.p_value)[:MOST]
    if not tested:
        return None
    claimed = {name for effect in result.effects for name in effect.members}
    left = {name for group in result.survivors for each in group for name in each.split(" + ")}
    kinds = [
        ("claimed, with its class", BLUE, [c for c in tested if c.name in claimed]),
        ("remains", GREEN, [c for c in tested if c.name in left - claimed]),
        ("not claimed", GREY, [c for c in tested if c.name not in claimed | left]),
    ]
    with styled():
        drawn = figure(0.85 + 0.19 * len(tested))
        axes = drawn.subplots()
        for label, colour, group in kinds:
            for seen, face in ((True, colour), (False, "none")):
                some = [c for c in group if c.detectable == seen]
                if some:
                    y = np.array([tested.index(c) for c in some])
                    x = -np.log10([max(c.p_value, LEAST) for c in some])
                    axes.hlines(y[x > 0.0], 0.0, x[x > 0.0], color=colour, linewidth=1.6)
                    name = label if seen else f"{label}, not detectable"
                    axes.scatter(
                        x, y, s=22, facecolor=face, edgecolor=colour, linewidth=1.2, zorder=3, label=name
                    )
        axes.set_yticks(range(len(tested)), [short(one.name, LONGEST) for one in tested])
        axes.set_ylim(len(tested) - 0.4, -0.6)
        axes.set_xlim(left=0.0)
        axes.grid(visible=False, axis="y")
        axes.set_xlabel("score: \u2212log\u2081\u2080 of the p-value of this candidate alone [1]")
        marks.legend(axes)
    return drawn


def pulls(values: Sequence[Corrected]) -> Figure | None:
    """Return how far the fit moved each value, in standard deviations of its prior; None if none has a prior."""
    known = [(value, value.prior_sigma) for value in values if value.prior_sigma]
    moved = [((v.value - v.declared) / prior, v.sigma / prior, v.name) for v, prior in known]
    shown = sorted(moved, key=lambda one: -abs(one[0]))[:MOST]
    if not shown:
        return None
    with styled():
        drawn = figure(0.8 + 0.21 * len(shown))
        axes = drawn.subplots()
        axes.axvspan(-1.0, 1.0, color=GREY, alpha=0.16, linewidth=0, label="prior, \u00b11 \u03c3")
        marks.zero_across(axes)
        away, width, names = zip(*shown, strict=True)
        axes.errorbar(
            away,
            range(len(shown)),
            xerr=width,
            fmt="o",
            color=BLUE,
            capsize=2.5,
            label="after the fit, \u00b11 \u03c3",
        )
        axes.set_yticks(range(len(shown)), [short(name, LONGEST) for name in names])
        axes.set_ylim(len(shown) - 0.4, -0.6)
        most = max(3.0, *(abs(a) + w for a, w, _ in shown)) * 1.05
        axes.set_xlim(-most, most)
        axes.grid(visible=False, axis="y")
        axes.set_xlabel("value \u2212 declared value [\u03c3 of the prior]")
        marks.legend(axes)
    return drawn
