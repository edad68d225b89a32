"""The table of a figure has the numbers that were given to it, whatever kind of figure it is."""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from helpers.pages.report_examples import made_up
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.panel import Panel
from pkmodes.pages.plots.setup_frequencies import setup_frequencies
from pkmodes.pages.plots.shapers import over_plane
from pkmodes.pages.plots.sheet import Sheet


def table(draw: Callable[[Sheet], Any]) -> list[dict[str, str]]:
    """Return the rows as a reader of CSV files finds them, without the columns that they leave empty."""
    lines = [",".join(cells) for cells in zip(*Drawing(draw).table, strict=True)]
    return [{name: cell for name, cell in row.items() if cell} for row in csv.DictReader(lines)]


def of(rows: list[dict[str, str]], name: str, **where: str) -> list[float]:
    return [
        float(r[name]) for r in rows if name in r and all(r.get(key) == value for key, value in where.items())
    ]


def test_curves_have_all_their_digits_and_the_labels_of_their_axes() -> None:
    x, y = np.array([1.0, 2.0, 3.5]), np.array([np.pi, np.nan, -np.e * 1e-7])

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        panel.plot(x, y, label="measured")
        panel.label(x="frequency [Hz]", y="size [m/N]")

    rows = table(draw)
    assert of(rows, "frequency [Hz]", series="measured") == [1.0, 3.5]
    assert of(rows, "size [m/N]", series="measured") == [np.pi, -np.e * 1e-7]


@pytest.mark.parametrize(("count", "digits"), [(3000, 9), (25_000, 6)])
def test_thousands_of_points_have_fewer_digits(count: int, digits: int) -> None:
    x = np.linspace(1.0, 2.0, count)
    rows = table(lambda sheet: sheet.panel(3.0).plot(x, -x))
    np.testing.assert_allclose(of(rows, "x"), x, rtol=0.5 * 10.0 ** (1 - digits), atol=0.0)
    assert max(len(row["x"]) for row in rows) == digits + 1  # with its point


def test_cells_are_at_the_places_and_have_the_values_that_were_given() -> None:
    x, y = np.array([0.1, 0.2, 0.3]), np.array([-5.0, 0.0])
    values = np.array([[1.0, 2.0, 3.123456], [4.0, np.nan, 6.0]])

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        sheet.colour_scale(panel.cells(x, y, values), "f [Hz]")

    rows = table(draw)
    found = {(float(r["x"]), float(r["y"])): float(r["f [Hz]"]) for r in rows}
    assert found == {(x[k], y[i]): values[i, k] for i, k in np.argwhere(np.isfinite(values)).tolist()}


def test_the_places_of_cells_have_no_rounding_of_their_unit() -> None:
    x = np.array([0.1 + 0.2, 0.4])
    rows = table(lambda sheet: sheet.panel(3.0).cells(x, x, np.eye(2)))
    assert {row["x"] for row in rows} == {"0.3", "0.4"}


def test_the_cells_of_an_image_are_at_its_rows_and_columns() -> None:
    values = np.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
    found = {(r["x"], r["y"]): r["value"] for r in table(lambda sheet: sheet.panel(3.0).image(values))}
    assert found == {(str(k), str(i)): str(2 * i + k + 1) for i in range(3) for k in range(2)}


def test_marks_have_their_values() -> None:
    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        marks = panel.scatter([1.0, 2.0], [3.0, 4.0], values=[0.25, 0.75], label="poses")
        sheet.colour_scale(marks, "left [%]")

    assert of(table(draw), "left [%]", series="poses") == [0.25, 0.75]


def test_error_bars_bands_and_bars_have_their_ends() -> None:
    def draw(sheet: Sheet) -> None:
        (left,), (middle,), (right,) = sheet.groups(3, 3, 3.0)
        left.error_bars([5.0, 6.0], [1.0, 2.0], [0.5, 0.25], label="fit")
        middle.band([0.0, 1.0, 2.0], [1.0, 2.0, np.nan], [2.0, 4.0, 6.0], name="range")
        right.bar(0.0, 0.0, 7.0, label="share")
        right.bar(1.0, -8.0, 8.0, label="all")
        for panel, title in zip((left, middle, right), "lmr", strict=True):
            panel.label(title)

    rows = table(draw)
    assert of(rows, "x", series="fit") == [5.0, 6.0]
    assert of(rows, "x", series="fit, lower end") == [4.5, 5.75]
    assert of(rows, "x", series="fit, upper end") == [5.5, 6.25]
    assert of(rows, "y", series="fit, upper end") == [1.0, 2.0]
    assert of(rows, "x", series="range, lower limit") == [0.0, 1.0]
    assert of(rows, "y", series="range, lower limit") == [1.0, 2.0]
    assert of(rows, "y", series="range, upper limit") == [2.0, 4.0]
    assert of(rows, "x", series="share", panel="r") == [7.0]
    assert of(rows, "x", series="all, lower end") == [-8.0]
    assert of(rows, "x", series="all, upper end") == [8.0]
    assert of(rows, "y", panel="r") == [0.0, 1.0, 1.0]


def test_lines_are_numbered_pieces() -> None:
    ends, heights = np.array([[0.0, 2.0], [1.0, 3.0]]), np.array([[5.0], [7.0]])
    rows = table(lambda sheet: sheet.panel(3.0).lines(ends, heights, label="model"))
    assert of(rows, "part", series="model") == [1, 1, 2, 2]
    assert of(rows, "x") == [0.0, 2.0, 1.0, 3.0]
    assert of(rows, "y") == [5.0, 5.0, 7.0, 7.0]


def test_inner_panels_have_the_labels_that_they_share_and_the_title_above_them() -> None:
    def draw(sheet: Sheet) -> None:
        groups = sheet.groups(2, 2, 3.0, rows=(1.0, 1.0), share_x=True)
        for k, (title, (above, below)) in enumerate(zip(("first", "second"), groups, strict=True)):
            above.plot([1.0], [10.0 * k], "o")
            below.plot([1.0], [10.0 * k + 20.0], "o")
            above.label(title, x="f [Hz]", y="size [m]")
            below.label(title, x="f [Hz]", y="phase [deg]")

    rows = table(draw)
    assert [r["f [Hz]"] for r in rows] == ["1"] * 4
    assert of(rows, "size [m]", panel="first") == [0.0]
    assert of(rows, "size [m]", panel="second") == [10.0]
    assert of(rows, "phase [deg]", panel="second") == [30.0]
    assert [r["panel"] for r in rows] == ["first", "second"] * 2, "row by row, as a wide figure is read"


def test_a_wide_figure_leaves_titles_and_labels_to_the_panels_above_beside_and_below() -> None:
    def draw(sheet: Sheet) -> None:
        for k, panels in enumerate(sheet.groups(3, 2, 4.0, rows=(1.0, 1.0))):
            for panel in panels:
                panel.label(f"group {k}", x="across", y="up")

    axes = [panel.axes for panel in Drawing(draw).wide.panels]
    assert [one.get_title(loc="left") for one in axes] == ["group 0", "group 1", "", "", "group 2", ""]
    assert [one.get_ylabel() for one in axes] == ["up", "", "up", "", "up", "up"]
    assert [one.get_xlabel() for one in axes] == ["", "", "", "across", "", "across"]


def test_a_row_of_panels_has_its_name_in_the_name_of_each_panel() -> None:
    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        panel.plot([1.0], [2.0], "o")
        panel.label("mode 1", x="mode", y="mode", row="in plane")

    (row,) = table(draw)
    assert row == {"panel": "mode 1, in plane", "series": "marks 1", "x: mode": "1", "y: mode": "2"}


def test_an_axis_of_names_has_them_beside_its_numbers() -> None:
    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        panel.plot([-0.2, 0.2, 1.0], [1.0, 2.0, 3.0], "o")
        panel.set_tick_names("x", [0, 1], ["P1", "P\n2"], ["P1", "P2"])
        panel.set_tick_names("y", [1, 2, 3], ["1", "2", "3"])
        panel.label(x="pose")

    rows = table(draw)
    assert [r["pose (name)"] for r in rows] == ["P1", "P1", "P2"]
    assert "y (name)" not in rows[0], "numbers are no names"


def test_a_line_across_has_one_place() -> None:
    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        panel.plot([1.0, 2.0], [1.0, 2.0], name="model")
        panel.vertical_line(1.5, "mode")

    rows = table(draw)
    assert [row for row in rows if row["series"] == "mode"] == [{"series": "mode", "x": "1.5"}]


def test_values_that_are_kinds_have_their_names() -> None:
    def draw(sheet: Sheet) -> None:
        values = np.array([[0.0, 1.0, np.nan]])
        sheet.panel(3.0).cells(np.arange(3.0), np.zeros(1), values, ["mass", "width"])

    assert [r["value (name)"] for r in table(draw)] == ["mass", "width"]


@pytest.mark.parametrize(
    "text", ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", " =1", "\r=1", "\uff1d1", '=HYPERLINK("a","b")']
)
def test_no_text_is_a_formula_of_a_spreadsheet(text: str) -> None:
    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        panel.plot([1.0], [-2.0], "o", label=text)
        panel.label(text, x=text)

    for cells in Drawing(draw).table:
        for cell in cells:
            assert "\n" not in cell
            assert "\r" not in cell
            plain = cell.strip('"').lstrip()
            assert not plain or (plain[0] not in "=+@\uff1d" and (plain[0] != "-" or float(plain) == -2.0))
    assert of(table(draw), "y") == [-2.0]


def test_a_figure_of_many_cells_keeps_fewer_digits_and_says_no_more_than_its_colours() -> None:
    values = np.linspace(1.0, 2.0, 90_000).reshape(300, 300)
    rows = table(lambda sheet: sheet.panel(3.0).cells(np.arange(300.0), np.arange(300.0), values))
    found = np.array(of(rows, "value")).reshape(300, 300)
    np.testing.assert_allclose(found, values, rtol=5e-5)  # five digits: half a unit of the last of 1.0000
    assert max(len(row["value"]) for row in rows) == len("1.0000")


def test_a_layer_of_three_components_has_the_two_that_vary_and_what_is_left_there() -> None:
    points = np.array([[0.1, 0.0], [0.2, 0.0], [0.1, 0.05], [0.2, 0.05]])
    names, units = ("x", "y", "z"), (("mm", 1e3),) * 3
    columns = over_plane(points, names, units, {"zv": np.array([1.0, 2.0, 3.0, 4.0])}).table
    assert columns == [
        ["panel", *["zv"] * 4],
        ["series", *["cells 1"] * 4],
        ["x [mm]", "100", "200", "100", "200"],
        ["y [mm]", "0", "0", "50", "50"],
        ["left [%]", "1", "2", "3", "4"],
    ]


def test_each_frequency_has_the_limits_of_its_own_band() -> None:
    result, data = made_up(1, 2)
    evidence = PlottedEvidence.of(result, data)
    frequencies, sigmas = evidence.stages[0].predicted.elastic_frequencies[0, :2], np.array([1.0, 3.0])
    drawing = setup_frequencies(replace(evidence, frequency_sigma=sigmas[None]))
    for end, limits in (("lower", frequencies - sigmas), ("upper", frequencies + sigmas)):
        rows = table(drawing.draw)
        found = of(rows, "frequency [Hz]", series=f"\u00b1 \u03c3 as declared, {end} limit")
        np.testing.assert_allclose(found, limits)


def test_an_empty_figure_has_no_table() -> None:
    assert Drawing(lambda sheet: None).table == []
    assert Drawing(lambda sheet: Panel(sheet.panel(3.0).axes).label("t")).table == []
