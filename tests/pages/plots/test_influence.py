"""The influence of parameters: numbers that can be read on every cell, and a legend in the colours of the map."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import matplotlib
import numpy as np
import pytest
import xarray
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure

from pkmodes.pages.plots import influence
from pkmodes.pages.plots.dominant import (
    PARAMETER_COLOURS,
    dominant_parameters,
    region_centres,
    strongest_parameters,
)
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.plane import Plane
from pkmodes.pages.plots.svg import inline_svg

SVG = "{http://www.w3.org/2000/svg}"
PATHS = ["platform.mass", "belt.width", "link.length"]


def luminance(colour: str) -> float:
    """By the definition of WCAG 2.1."""
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in to_rgb(colour))
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def table_of(values: list[list[float]]) -> Figure:
    return influence.influence_table(PATHS[: len(values)], np.array(values)[None, None]).figure


def plane() -> Plane:
    x = np.linspace(0.0, 1.0, 5)
    axes = {name: (name, x, {"units": "m"}) for name in ("y", "x")}
    valid = (("y", "x"), np.ones((5, 5), dtype=bool))
    return Plane(xarray.Dataset({"valid": valid}, coords=axes), "x", "y", None, 0.0)


@pytest.mark.parametrize("size", np.linspace(-1.0, 1.0, 21))
def test_every_number_can_be_read_on_its_cell_whatever_the_colours_of_the_page(size: float) -> None:
    drawn = table_of([[1.0, size]])
    page = ElementTree.fromstring(inline_svg(drawn, "t", "d"))
    written = [e.attrib["style"] for e in page.iter(f"{SVG}text") if re.search(r"\d\.\d\d$", e.text or "")]
    ink = re.search(r"fill: (#\w{6})", written[1])
    # matplotlib leaves out black, which is the default of SVG.
    colour = ink[1] if ink else "#000000"
    assert "currentColor" not in written[1]
    cell = to_hex(matplotlib.colormaps["PuOr"]((size + 1.0) / 2.0))
    assert contrast(colour, cell) >= 4.5


def test_what_is_rounded_to_zero_has_no_sign() -> None:
    drawn = table_of([[1.0, -0.001, 0.004, -0.006]])
    assert [text.get_text() for text in drawn.axes[0].texts] == ["+1.00", "0.00", "0.00", "\u22120.01"]


def test_parameters_that_act_as_one_have_a_line_each_in_the_name_of_their_row() -> None:
    drawn = influence.influence_table(["belt.specific_stiffness, belt.width"], np.ones((1, 1, 1, 1))).figure
    assert [t.get_text() for t in drawn.axes[0].get_yticklabels()] == ["belt.specific_stiffness,\nbelt.width"]


def test_the_legend_of_the_largest_influence_has_the_colours_of_the_map() -> None:
    relative = np.zeros((5, 5, 3, 1))
    relative[:, :, 2] = -1.0
    relative[0, 0, 1] = 2.0
    found = dominant_parameters(plane(), PATHS, relative)
    assert isinstance(found, Drawing)
    drawn = found.figure
    (legend,) = drawn.legends
    shown = {
        t.get_text(): to_hex(p.get_facecolor())
        for t, p in zip(legend.texts, legend.legend_handles, strict=True)
    }
    mesh = drawn.axes[0].collections[0]
    colours = [to_hex(c) for c in mesh.to_rgba(mesh.get_array()).reshape(-1, 4)]
    assert shown == {"2  belt.width": colours[0], "1  link.length": colours[-1]}
    written = {t.get_text(): t.get_position() for t in drawn.axes[0].texts}
    assert written == {"1": (500.0, 500.0)}  # mm, in the middle of its region; the other one has no room
    page = inline_svg(drawn, "t", "d")
    assert all(colour in page and f", {colour})" not in page for colour in shown.values())


def test_regions_can_be_told_apart_in_grey() -> None:
    """Any two colours differ by 7 of the 100 steps of lightness from black to white (CIE 1976 L*)."""
    lightness = sorted(116.0 * luminance(c) ** (1 / 3) - 16.0 for c in PARAMETER_COLOURS)
    assert min(np.diff(lightness)) >= 7.0


def test_each_region_with_room_has_its_number_in_its_middle() -> None:
    inside = np.zeros((12, 20), dtype=bool)
    inside[1:8, 1:8] = True  # middle (4, 4)
    inside[3:8, 12:17] = True  # (5, 14)
    inside[10, 1:19] = True  # a sliver
    assert list(region_centres(inside)) == [(4, 4), (5, 14)]
    assert list(region_centres(np.zeros((3, 3), dtype=bool))) == []


def test_one_parameter_everywhere_is_a_sentence() -> None:
    relative = np.zeros((5, 5, 3, 2))
    relative[..., 1, :] = 0.5
    same = dominant_parameters(plane(), PATHS, relative)
    relative[..., 2, 1] = -0.7
    other = dominant_parameters(plane(), PATHS, relative)
    assert same == "At every pose each frequency changes most with belt.width, of 3 parameters."
    assert other == (
        "At every pose the frequencies change most with the same ones of 3 parameters: that of mode 1 with "
        "belt.width; that of mode 2 with link.length."
    )


def test_parameters_with_equal_influence_are_drawn_as_a_tie() -> None:
    """Rounding decides nothing: a region where two are equal is one region, named after both."""
    relative = np.zeros((5, 5, 3, 1))
    relative[:, :, 0] = 0.2
    relative[:, 3:, 1] = 0.5
    relative[:, 3:, 2] = -0.5 * (1.0 + 1e-15 * np.random.default_rng(1).normal(size=(5, 2, 1)))
    drawn = dominant_parameters(plane(), PATHS, relative)
    assert isinstance(drawn, Drawing)
    (legend,) = drawn.figure.legends
    assert [text.get_text() for text in legend.texts] == [
        "1  platform.mass",
        "2  belt.width and\nlink.length alike",
    ]
    assert legend.get_title().get_text() == "largest |d ln f / d ln p| of 3 parameters; alike: within 1 %"
    colours = drawn.figure.axes[0].collections[0].get_array()
    assert len(np.unique(colours[:, :3])) == len(np.unique(colours[:, 3:])) == 1


def test_a_tie_within_a_hundredth_is_one_and_a_larger_difference_none() -> None:
    relative = np.full((1, 4, 2, 1), 0.5)
    relative[0, :2, 1] *= 0.995
    relative[0, 2:, 1] *= 0.985
    sets, index = strongest_parameters(relative)
    assert [sets[i] for i in index.ravel()] == [(0, 1), (0, 1), (0,), (0,)]


def test_the_line_between_two_regions_is_no_region() -> None:
    """Within 1 % of one another are two of 300 poses."""
    relative = np.full((1, 301, 2, 1), 0.5)
    relative[0, :, 1, 0] = np.linspace(0.0, 1.5, 301)
    sets, index = strongest_parameters(relative)
    assert sets == [(0,), (1,)]
    assert (index[0, :100] == 0).all()
    assert (index[0, 101:] == 1).all()


def test_a_tie_everywhere_is_a_sentence() -> None:
    relative = np.zeros((5, 5, 3, 1))
    relative[:, :, 1:] = 0.5
    assert dominant_parameters(plane(), PATHS, relative) == (
        "At every pose each frequency changes most with belt.width and link.length alike (within 1 %), of 3 "
        "parameters."
    )
