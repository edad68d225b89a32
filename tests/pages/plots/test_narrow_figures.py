"""Figures for narrow screens: their panels in one column, each with its own title and labels."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.responses import responses
from pkmodes.pages.plots.sheet import NARROW_WIDTH, Sheet
from pkmodes.pages.plots.style import figure_style


def settled(drawing: Drawing) -> Sheet:
    """Return a narrow sheet after its layout; it fits."""
    with figure_style():
        sheet = drawing.sheet(narrow=True)
        assert sheet.lay_out_narrow() is not None
    return sheet


def from_the_top(sheet: Sheet) -> list[Any]:
    return sorted(sheet.figure.axes, key=lambda axes: -axes.get_position().y0)


def test_the_phase_of_a_channel_has_the_title_of_its_magnitude() -> None:
    f = np.linspace(5.0, 200.0, 50)
    names = ["p_x/motor_1", "p_x/force_x", "p_z/motor_1", "p_z/force_x"]
    sheet = settled(
        responses(f, dict.fromkeys(names, 1.0 / (1.0 - (f / 50.0) ** 2 + 0.1j)), dict.fromkeys(names, "m"))
    )
    panels = from_the_top(sheet)
    assert [axes.get_title(loc="left") for axes in panels] == [name for name in names for _ in range(2)]
    assert ["phase" in axes.get_ylabel() for axes in panels] == [False, True] * 4
    assert {axes.get_xlabel() for axes in panels} == {"frequency [Hz]"}


@pytest.mark.parametrize(("columns", "rows"), [(3, 1), (2, 2)])
def test_panels_follow_each_other_group_by_group_and_no_text_lies_on_another(columns: int, rows: int) -> None:
    def draw(sheet: Sheet) -> None:
        groups = sheet.groups(4, columns, 4.0, rows=(1.0,) * rows, share_y=True)
        for k, panels in enumerate(groups):
            for i, panel in enumerate(panels):
                panel.plot([0.0, 1.0], [0.0, 1.0], label=f"curve {k}")
                panel.label(f"{k}{i}", x="across [mm]", y="up [Hz]")

    sheet = settled(Drawing(draw))
    panels = from_the_top(sheet)
    assert [axes.get_title(loc="left") for axes in panels] == [
        f"{k}{i}" for k in range(4) for i in range(rows)
    ]
    for axes in panels:
        assert (axes.get_xlabel(), axes.get_ylabel()) == ("across [mm]", "up [Hz]")
        assert axes.bbox.width > 0.75 * NARROW_WIDTH * sheet.figure.dpi
    with figure_style():
        boxes = [axes.get_tightbbox() for axes in panels]
    assert all(upper.y0 >= lower.y1 for upper, lower in pairwise(boxes))


def test_a_legend_stands_above_the_title_and_the_names_that_stand_above_a_panel() -> None:
    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        for name in ("pole", "stable pole", "a mode of the record", "struck out", "tone"):
            panel.plot([0.0, 1.0], [0.0, 1.0], label=name)
        for x, name in ((0.1, "1"), (0.5, "2"), (0.7, "3")):
            panel.axes.text(x, 1.02, name, transform=panel.axes.transAxes, va="bottom")
        panel.label("a title", x="x", y="y", pad=20.0)
        sheet.legend(panel, loc="lower left", bbox_to_anchor=(0.0, 1.13), ncols=5)

    sheet = settled(Drawing(draw))
    (legend,) = sheet.figure.legends
    (axes,) = sheet.figure.axes
    with figure_style():
        box = legend.get_window_extent()
        below = [axes.title.get_window_extent(), *(text.get_window_extent() for text in axes.texts)]
        below.append(axes._left_title.get_window_extent())  # type: ignore[attr-defined]
    assert box.width <= NARROW_WIDTH * sheet.figure.dpi
    assert all(box.y0 >= one.y1 for one in below)


def test_names_that_would_lie_on_each_other_are_turned() -> None:
    def draw(sheet: Sheet, names: list[str]) -> None:
        panel = sheet.panel(3.0)
        panel.plot(range(len(names)), range(len(names)), "o")
        panel.set_tick_names("x", range(len(names)), names)
        panel.label(x="pose", y="f [Hz]")

    for names, turned in ((["P1", "P2", "P3"], 0.0), ([f"a long name {k}" for k in range(8)], 90.0)):
        (axes,) = settled(Drawing(lambda sheet, names=names: draw(sheet, names))).figure.axes
        labels = axes.get_xticklabels()
        assert {label.get_rotation() for label in labels} == {turned}
        with figure_style():
            boxes = [label.get_window_extent() for label in labels]
        assert not any(one.overlaps(other) for one, other in pairwise(boxes))


def test_panels_side_by_side_share_the_label_beside_them() -> None:
    def draw(sheet: Sheet) -> None:
        sheet.groups(4, 4, 3.0, height_to_width=1.5)
        for panel in sheet.panels:
            panel.plot([0.0, 1.0], [0.0, 1.5], "o")
            panel.axes.set_aspect("equal")
            panel.label("a map", x="x [mm]", y="y [mm]")

    sheet = settled(Drawing(draw))
    assert [panel.axes.get_ylabel() for panel in sheet.panels] == ["y [mm]", ""] * 2
    assert [panel.axes.get_xlabel() for panel in sheet.panels] == ["x [mm]"] * 4


def test_a_figure_whose_texts_lie_on_each_other_does_not_fit() -> None:
    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        panel.axes.text(0.1, 0.5, "a number that is long")
        panel.axes.text(0.2, 0.5, "and another")

    with figure_style():
        assert Drawing(draw).sheet(narrow=True).lay_out_narrow() is None
        assert Drawing(lambda sheet: None).sheet(narrow=True).lay_out_narrow() is None
