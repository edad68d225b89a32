"""Figures for narrow screens: their panels in one column, each with its own title or that of the panel above it."""

from __future__ import annotations

import numpy as np

from pkmodes.plots.narrow import narrowed
from pkmodes.plots.responses import responses
from pkmodes.plots.style import figure, styled


def test_the_phase_of_a_channel_has_the_title_of_its_magnitude() -> None:
    f = np.linspace(5.0, 200.0, 50)
    names = ["p_x/motor_1", "p_x/force_x", "p_z/motor_1", "p_z/force_x"]
    with styled():
        drawn = responses(
            f, dict.fromkeys(names, 1.0 / (1.0 - (f / 50.0) ** 2 + 0.1j)), dict.fromkeys(names, "m")
        )
        assert narrowed(drawn)
    panels = sorted(drawn.axes, key=lambda axes: -axes.get_position().y0)
    assert [axes.get_title(loc="left") for axes in panels] == [name for name in names for _ in range(2)]
    assert ["phase" in axes.get_ylabel() for axes in panels] == [False, True] * 4


def test_a_legend_stands_above_the_names_that_stand_above_a_panel() -> None:
    with styled():
        drawn = figure(3.0)
        axes = drawn.subplots()
        for name in ("pole", "stable pole", "mode", "tone"):
            axes.plot([0.0, 1.0], [0.0, 1.0], label=name)
        names = [
            axes.text(x, 1.02, str(k), transform=axes.transAxes, va="bottom")
            for k, x in enumerate((0.1, 0.5, 0.7))
        ]
        axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.13), ncols=4)
        assert narrowed(drawn)
        legend = axes.get_legend()
        assert legend is not None
        box = legend.get_window_extent()
        assert not any(box.overlaps(text.get_window_extent()) for text in names)
