"""The numbers of a figure are those that were drawn, whatever kind of figure it is."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from pkmodes.plots.drawn_data import drawn_data
from pkmodes.plots.style import figure, styled


@pytest.fixture(autouse=True)
def style() -> Iterator[None]:
    with styled():
        yield


def table(drawn: Any) -> list[dict[str, str]]:
    """Return the rows as a reader of CSV files finds them, without the columns that they leave empty."""
    lines = [",".join(cells) for cells in zip(*drawn_data(drawn), strict=True)]
    return [{name: cell for name, cell in row.items() if cell} for row in csv.DictReader(lines)]


def of(rows: list[dict[str, str]], name: str, **where: str) -> list[float]:
    return [
        float(r[name]) for r in rows if name in r and all(r.get(key) == value for key, value in where.items())
    ]


def test_curves_have_all_their_digits_and_the_labels_of_their_axes() -> None:
    x, y = np.array([1.0, 2.0, 3.5]), np.array([np.pi, np.nan, -np.e * 1e-7])
    drawn = figure(3.0)
    axes = drawn.subplots()
    axes.plot(x, y, label="measured")
    axes.set_xlabel("frequency [Hz]")
    axes.set_ylabel("size [m/N]")
    rows = table(drawn)
    assert of(rows, "frequency [Hz]", series="measured") == [1.0, 3.5]
    assert of(rows, "size [m/N]", series="measured") == [np.pi, -np.e * 1e-7]


def test_cells_are_at_the_places_and_have_the_values_that_were_given() -> None:
    x, y = np.array([0.1, 0.2, 0.3]), np.array([-5.0, 0.0])
    values = np.array([[1.0, 2.0, 3.123456], [4.0, np.nan, 6.0]])
    drawn = figure(3.0)
    axes = drawn.subplots()
    mesh = axes.pcolormesh(x, y, np.ma.masked_invalid(values), shading="nearest")
    drawn.colorbar(mesh, ax=axes).set_label("f [Hz]")
    rows = table(drawn)
    found = {(float(r["x"]), float(r["y"])): float(r["f [Hz]"]) for r in rows}
    assert found == {(x[k], y[i]): values[i, k] for i, k in np.argwhere(np.isfinite(values)).tolist()}


def test_the_cells_of_an_image_are_at_its_rows_and_columns() -> None:
    drawn = figure(3.0)
    drawn.subplots().imshow([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
    found = {(r["x"], r["y"]): r["value"] for r in table(drawn)}
    assert found == {(str(k), str(i)): str(2 * i + k + 1) for i in range(3) for k in range(2)}


def test_marks_have_their_values() -> None:
    drawn = figure(3.0)
    marks = drawn.subplots().scatter([1.0, 2.0], [3.0, 4.0], c=[0.25, 0.75], label="poses")
    drawn.colorbar(marks).set_label("left [%]")
    assert of(table(drawn), "left [%]", series="poses") == [0.25, 0.75]


def test_error_bars_bands_and_bars_have_their_ends() -> None:
    drawn = figure(3.0)
    left, middle, right = drawn.subplots(1, 3)
    left.errorbar([1.0, 2.0], [5.0, 6.0], yerr=[0.5, 0.25], label="fit")
    middle.fill_between([0.0, 1.0, 2.0], [1.0, 2.0, 3.0], [2.0, 4.0, 6.0], label="range")
    right.barh([0.0, 1.0], [7.0, 8.0], label="share")
    for axes, title in zip((left, middle, right), "lmr", strict=True):
        axes.set_title(title)
    rows = table(drawn)
    assert of(rows, "y", series="fit") == [5.0, 6.0]
    assert of(rows, "y", series="fit, lower end") == [4.5, 5.75]
    assert of(rows, "y", series="fit, upper end") == [5.5, 6.25]
    assert of(rows, "y", series="range, lower limit") == [1.0, 2.0, 3.0]
    assert of(rows, "y", series="range, upper limit") == [2.0, 4.0, 6.0]
    assert of(rows, "x", series="share", panel="r") == [7.0, 8.0]


def test_inner_panels_have_the_labels_that_they_share_and_the_title_above_them() -> None:
    drawn = figure(3.0)
    panels = drawn.subplots(2, 2, sharex=True)
    for k, axes in enumerate(panels.flat):
        axes.plot([1.0], [10.0 * k], "o")
    panels[0, 0].set_title("first")
    panels[0, 1].set_title("second")
    panels[1, 0].set_xlabel("f [Hz]")
    panels[1, 1].set_xlabel("f [Hz]")
    panels[0, 0].set_ylabel("size [m]")
    panels[1, 0].set_ylabel("phase [deg]")
    rows = table(drawn)
    assert [r["f [Hz]"] for r in rows] == ["1"] * 4
    assert of(rows, "size [m]", panel="first") == [0.0]
    assert of(rows, "size [m]", panel="second") == [10.0]
    assert of(rows, "phase [deg]", panel="second") == [30.0]


def test_an_axis_of_names_has_them_beside_its_numbers() -> None:
    drawn = figure(3.0)
    axes = drawn.subplots()
    axes.plot([-0.2, 0.2, 1.0], [1.0, 2.0, 3.0], "o")
    axes.set_xticks([0, 1], ["P1", "P2"])
    axes.set_xlabel("pose")
    assert [r["pose (name)"] for r in table(drawn)] == ["P1", "P1", "P2"]


def test_a_series_is_found_in_the_legend_by_its_look() -> None:
    from matplotlib.lines import Line2D

    drawn = figure(3.0)
    axes = drawn.subplots()
    axes.plot([1.0, 2.0], [1.0, 2.0], color="#0072b2")
    axes.axvline(1.5, color="#d55e00")
    axes.axhline(0.0, color="#000000")
    handles = [Line2D([], [], color="#0072b2"), Line2D([], [], color="#d55e00")]
    drawn.legend(handles, ["model", "mode"])
    rows = table(drawn)
    assert {r["series"] for r in rows} == {"model", "mode"}
    assert of(rows, "x", series="mode") == [1.5]


def test_colours_that_a_legend_names_have_their_names() -> None:
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    drawn = figure(3.0)
    settings = {"cmap": ListedColormap(["#ff0000", "#00ff00"]), "vmin": -0.5, "vmax": 1.5}
    drawn.subplots().pcolormesh([0.0, 1.0], [0.0], [[0.0, 1.0]], shading="nearest", **settings)
    drawn.legend(handles=[Patch(color="#ff0000", label="mass"), Patch(color="#00ff00", label="width")])
    assert [r["value (name)"] for r in table(drawn)] == ["mass", "width"]


@pytest.mark.parametrize(
    "text", ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", " =1", "\r=1", "\uff1d1", '=HYPERLINK("a","b")']
)
def test_no_text_is_a_formula_of_a_spreadsheet(text: str) -> None:
    drawn = figure(3.0)
    axes = drawn.subplots()
    axes.plot([1.0], [-2.0], "o", label=text)
    axes.set_title(text)
    axes.set_xlabel(text)
    columns = drawn_data(drawn)
    for cells in columns:
        for cell in cells:
            assert "\n" not in cell
            assert "\r" not in cell
            plain = cell.strip('"').lstrip()
            assert not plain or (plain[0] not in "=+@\uff1d" and (plain[0] != "-" or float(plain) == -2.0))
    assert of(table(drawn), "y") == [-2.0]


def test_a_figure_of_many_cells_keeps_fewer_digits_and_says_no_more_than_its_colours() -> None:
    drawn = figure(3.0)
    values = np.linspace(1.0, 2.0, 90_000).reshape(300, 300)
    drawn.subplots().pcolormesh(np.arange(300.0), np.arange(300.0), values, shading="nearest")
    found = np.array(of(table(drawn), "value")).reshape(300, 300)
    np.testing.assert_allclose(found, values, rtol=5e-5)  # five digits: half a unit of the last of 1.0000


def test_an_empty_figure_has_no_table() -> None:
    drawn = figure(3.0)
    drawn.subplots()
    assert drawn_data(drawn) == []
