"""Tornado charts: sorted bars of the changes that differences give, filled for a rise, grey for all together."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

import pkmodes
from pkmodes.loop.sensitivity.changes import PERCENT, Changes
from pkmodes.pages.figures import tornado_picture
from pkmodes.pages.plots.style import BLUE, GREY
from pkmodes.pages.plots.svg import inline_svg
from pkmodes.pages.plots.tornado import wrapped_name

PRINTER, AT = "robots/corexy-printer.toml", [0.1, 0.15]


def bars(axes: Axes, colour: str) -> dict[str, float]:
    """Ends of the bars of a colour by the name beside them, from top to bottom."""
    names = [label.get_text().replace("\n", " ") for label in axes.get_yticklabels()]
    found = {}
    for bar in axes.patches:
        assert isinstance(bar, Rectangle)
        if to_hex(bar.get_facecolor()) == colour:
            ends = (bar.get_x(), bar.get_x() + bar.get_width())
            found[names[round(bar.get_y() + bar.get_height() / 2)]] = max(ends, key=abs)
    return found


def difference(model: pkmodes.Model, path: str, change: float) -> np.ndarray:
    """Change of both frequencies of vibration by central differences with a thousandth of the change."""
    value = model.robot.quantities[path].value
    up, down = (
        model.with_values({path: value + sign * 1e-3 * change}).frequencies(AT)[-2:] for sign in (1, -1)
    )
    return (up - down) / 2e-3


def drawn_of(model: pkmodes.Model, by: str) -> Figure:
    return tornado_picture(model, AT, by=by).figure


def test_bars_of_a_per_cent_are_those_of_differences_the_longest_on_top() -> None:
    model = pkmodes.load(PRINTER)
    for mode, axes in enumerate(drawn_of(model, "percent").axes):
        found = bars(axes, BLUE)
        assert [*found.values()] == sorted(found.values(), key=lambda size: -abs(size))
        assert "belt.specific_stiffness, belt.width" in found, "one bar: they act as one"
        for name, size in found.items():
            path = name.partition(",")[0]
            expected = difference(model, path, 0.01 * model.robot.quantities[path].value)[mode]
            assert size == pytest.approx(expected, rel=1e-5)
        assert axes.get_title(loc="left") == f"mode {mode + 1}, {model.frequencies(AT)[-2:][mode]:.2f} Hz"


def test_bars_by_sigma_end_with_all_together() -> None:
    model = pkmodes.load(PRINTER)
    sigmas = {path: q.sigma for path, q in model.robot.quantities.items() if q.sigma}
    expected = {path: difference(model, path, sigma) for path, sigma in sigmas.items()}
    for mode, axes in enumerate(drawn_of(model, "sigma").axes):
        found = bars(axes, BLUE)
        assert found.keys() == sigmas.keys()
        for path, size in found.items():
            assert size == pytest.approx(expected[path][mode], rel=1e-5)
        (together,) = bars(axes, GREY).values()
        squares = sum(change[mode] ** 2 for change in expected.values())
        assert abs(together) == pytest.approx(np.sqrt(squares), rel=1e-5)
        low, high = axes.get_xlim()
        assert low == -high
        assert high > abs(together)


def test_the_saved_table_says_which_bars_are_for_more_and_which_for_less() -> None:
    model = pkmodes.load(PRINTER)
    for by, expected in (
        ("percent", {"1 % more", "1 % less"}),
        (
            "sigma",
            {"one sigma more", "one sigma less", "all together, lower end", "all together, upper end"},
        ),
    ):
        drawing = tornado_picture(model, AT, by=by).drawing
        assert drawing is not None
        table = {column[0]: column[1:] for column in drawing.table}
        assert {name.strip('"') for name in table["series"]} == expected


def test_at_most_ten_are_in_a_panel() -> None:
    model = pkmodes.load("robots/linear-delta-2022-identified.toml")
    figure = tornado_picture(model, [0.6, 0.03, -0.245]).figure
    assert [len(bars(axes, BLUE)) for axes in figure.axes][:3] == [10, 10, 10]
    page = ElementTree.fromstring(inline_svg(figure, "t", "d"))
    assert page.attrib["viewBox"]


def test_by_something_else_or_without_sigmas_is_refused() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml")
    with pytest.raises(pkmodes.PkmodesError, match='expected "percent" or "sigma"'):
        tornado_picture(model, [0.6, 0.0, -0.245], by="per mille")
    with pytest.raises(pkmodes.PkmodesError, match="has a standard deviation"):
        tornado_picture(model, [0.6, 0.0, -0.245], by="sigma")


def test_long_names_are_broken() -> None:
    assert wrapped_name("belt.width") == "belt.width"
    assert wrapped_name("effects.gearbox_compliance.compliance") == "effects.gearbox_compliance\n.compliance"


def test_of_all_modes_the_largest_fraction_of_a_frequency_comes_first() -> None:
    names = (("a",), ("b",))
    changes = Changes(
        PERCENT, names, names, np.array([10.0, 1000.0]), np.array([[0.0, 2.0], [-1.0, 0.0]]), None
    )
    assert changes.largest_of_all() == [1, 0]
    assert changes.largest(1) == [0]


def test_names_of_several_lines_do_not_run_into_their_neighbours() -> None:
    """A bed slinger has two bars in a panel, one of them with two names."""
    model = pkmodes.load("robots/bed-slinger.toml")
    figure = tornado_picture(model, [0.08, 0.03], by="percent").figure
    figure.draw_without_rendering()
    for axes in figure.axes:
        boxes = [label.get_window_extent() for label in axes.get_yticklabels() if label.get_text()]
        assert len(boxes) == 2
        assert not boxes[0].overlaps(boxes[1])
