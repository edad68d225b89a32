"""What the figures of a plane draw, read back from the drawing: a made-up map whose values say where they belong."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import xarray
from matplotlib.collections import LineCollection, QuadMesh
from matplotlib.colors import to_rgba
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure

from pkmodes.pages.plots import influence, maps
from pkmodes.pages.plots.dominant import dominant_parameters
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.mac_map import neighbouring_mac
from pkmodes.pages.plots.panels import rows_and_columns
from pkmodes.pages.plots.plane import Plane, plane_location
from pkmodes.pages.plots.sheet import NARROW_WIDTH
from pkmodes.pages.plots.style import figure_style
from pkmodes.pages.plots.workspace import ReachableVolume, workspace

X, Y = np.linspace(0.0, 0.4, 5), np.array([-0.1, 0.0, 0.1])
#: At (x_i, y_j), mode m: 100 m + 10 i + j; the first pose cannot be evaluated.
PLACE = 10.0 * np.arange(5)[:, None] + np.arange(3)
PLACE[0, 0] = np.nan
#: Quantiles of the other 14 places, 1, 2, 10 ... 41, 42: at 2 % of 13 intervals from each end, and at 10 %.
INNER, TENTH = (1.26, 41.74), (4.4, 40.7)
#: Motion of the platform along x, y, z: mode 1 is 3 along x and 4 along -z, mode 2 along -y only.
MOTION = np.array([[3.0, 0.0, -4.0], [0.0, -0.5, 0.0]])


@pytest.fixture(scope="module")
def plane() -> Plane:
    ones = np.where(np.isfinite(PLACE), 1.0, np.nan)
    numbers = np.array([100.0, 200.0])
    fields: dict[str, Any] = {
        "frequency": (("mode",), PLACE[..., None] + numbers),
        "in_plane": (("mode",), ones[..., None] * [0.3, 0.5]),
        "out_of_plane": (("mode",), ones[..., None] * [0.4, 0.0]),
        "platform_shape": (("mode", "direction"), ones[..., None, None] * MOTION),
        "condition": ((), PLACE),
        "valid": ((), np.isfinite(PLACE)),
    }
    # As a map has them: (z, y, x).
    data = {
        name: (("z", "y", "x", *dims), np.moveaxis(values, (0, 1), (1, 0))[None])
        for name, (dims, values) in fields.items()
    }
    metres = {"units": "m"}
    coords = {"x": ("x", X, metres), "y": ("y", Y, metres), "z": ("z", [-0.2], metres)}
    dataset = xarray.Dataset(data, {**coords, "mode": [1, 2], "direction": ["x", "y", "z"]})
    return Plane.of(dataset, ["x", "y", "z"])


@pytest.fixture(scope="module")
def varied(plane: Plane) -> Plane:
    """The plane with another motion at its last pose: along x alone, and a third smaller."""
    dataset = plane.dataset.copy(deep=True)
    dataset["platform_shape"].values[4, 2, 0] = [1.0, 0.0, 0.0]
    dataset["in_plane"].values[4, 2, 0] = 0.2
    return Plane(dataset, "y", "x", "z", -0.2)


#: The other poses.
LIKE = np.isfinite(PLACE) & (np.arange(15).reshape(5, 3) < 14)


def figure_of(drawing: Drawing | str) -> Figure:
    """Return the figure as wide as a page, with its panels."""
    assert isinstance(drawing, Drawing)
    return drawing.figure


def title(axes: Any) -> str:
    return str(axes.get_title(loc="left"))


def panels(figure: Figure) -> dict[str, Any]:
    """Axes by their title."""
    return {title(axes): axes for axes in figure.axes if title(axes)}


def maps_of(figure: Figure) -> list[Any]:
    """Axes with a colour map on the plane, without colour bars."""
    return [
        axes
        for axes in figure.axes
        if any(isinstance(c, QuadMesh) and c.get_array().shape == PLACE.shape for c in axes.collections)
    ]


def mesh_of(axes: Any) -> QuadMesh:
    (found,) = (one for one in axes.collections if isinstance(one, QuadMesh))
    return found


def shown(axes: Any) -> np.ndarray:
    """Values of a colour map by (vertical, horizontal) place; NaN where it is blank."""
    return np.ma.filled(mesh_of(axes).get_array().astype(float), np.nan)


def marks(axes: Any, marker: str) -> list[tuple[float, float]]:
    """Places of a kind of mark, (horizontal, vertical)."""
    lines = [line for line in axes.lines if line.get_marker() == marker]
    return [(float(x), float(y)) for line in lines for x, y in zip(*line.get_data(), strict=True)]


def test_each_frequency_is_drawn_at_its_place_on_a_scale_of_its_own(plane: Plane) -> None:
    figure = figure_of(maps.frequencies(plane, np.array([[-500.0, 100.0], [20.0, 900.0], [50.0, 200.0]])))
    found = panels(figure)
    assert list(found) == ["mode 1", "mode 2"]
    for number, axes in enumerate(found.values(), start=1):
        np.testing.assert_array_equal(shown(axes), PLACE + 100.0 * number)
        edges = mesh_of(axes).get_coordinates()
        np.testing.assert_allclose(edges[0, :, 0], [-150.0, -50.0, 50.0, 150.0])  # y [mm], across
        np.testing.assert_allclose(edges[:, 0, 1], np.arange(-50.0, 451.0, 100.0))  # x [mm], upwards
        assert axes.get_ylim() == pytest.approx((-50.0, 450.0))
        np.testing.assert_allclose(mesh_of(axes).get_clim(), np.array(INNER) + 100.0 * number)
        assert f"{number}01\u2013{number}42 Hz" in [text.get_text() for text in axes.texts]
        # The lowest value, 1, is at (0, 1), the highest at (4, 2).
        assert marks(axes, "v") == [pytest.approx((0.0, 0.0))]
        assert marks(axes, "^") == [pytest.approx((100.0, 400.0))]
        # Motors beyond the map are at its edge, hollow.
        assert marks(axes, "s") == [
            pytest.approx((-150.0, 100.0)),
            pytest.approx((20.0, 450.0)),
            pytest.approx((50.0, 200.0)),
        ]
        filled = [line.get_markerfacecolor() for line in axes.lines if line.get_marker() == "s"]
        assert filled == ["#ffffff", "#ffffff", "#000000"]
    assert found["mode 1"].get_xlabel() == "y [mm]"
    assert found["mode 1"].get_ylabel() == "x [mm]"


def test_lines_point_along_the_motion_and_colours_are_its_share_along_the_normal(varied: Plane) -> None:
    figure = figure_of(maps.directions(varied))
    found = panels(figure)
    assert varied.normal == "z"
    assert "share of the motion along z [1]" in [axes.get_ylabel() for axes in figure.axes]
    for name, share, half in (("mode 1", 0.8, (0.0, 27.0)), ("mode 2", 0.0, (45.0, 0.0))):
        axes = found[name]
        values = shown(axes)
        np.testing.assert_allclose(values[LIKE], share, atol=1e-9)
        assert values[4, 2] == pytest.approx(0.0, abs=1e-9)
        assert np.isnan(values[0, 0])
        assert mesh_of(axes).get_clim() == (0.0, 1.0)
        (strokes,) = (one for one in axes.collections if isinstance(one, LineCollection))
        ends = np.array(strokes.get_segments())
        assert len(ends) == 14
        middles = {tuple(np.round(place, 9)) for place in ends.mean(axis=1)}
        assert middles == {
            (y, x) for x in (0.0, 100.0, 200.0, 300.0, 400.0) for y in (-100.0, 0.0, 100.0)
        } - {(-100.0, 0.0)}
        # 0.45 of the distance of two lines at full length; mode 1 has 0.6 of its motion along x, upwards.
        np.testing.assert_allclose(
            np.abs(np.diff(ends, axis=1))[:-1, 0], np.tile(2.0 * np.array(half), (13, 1))
        )


def test_components_are_drawn_on_one_scale(varied: Plane) -> None:
    figure = figure_of(maps.components(varied))
    drawn = maps_of(figure)
    assert [axes.get_ylabel() for axes in drawn] == ["in plane\nx [mm]", "", "along z\nx [mm]", ""]
    assert [title(axes) for axes in drawn] == ["mode 1", "mode 2", "", ""]
    for axes, value in zip(drawn, (0.3, 0.5, 0.4, 0.0), strict=True):
        np.testing.assert_allclose(shown(axes)[LIKE], value)
        np.testing.assert_allclose(mesh_of(axes).get_clim(), (0.0, 0.5))


def test_each_mode_has_its_mac(plane: Plane) -> None:
    values = np.stack([PLACE / 100.0, 1.0 - PLACE / 100.0], axis=-1)
    found = panels(figure_of(neighbouring_mac(plane, values)))
    for mode, name in enumerate(("mode 1", "mode 2")):
        np.testing.assert_array_equal(shown(found[name]), values[..., mode])
        assert mesh_of(found[name]).get_clim() == (0.0, 1.0)


PATHS = ("platform.mass", "belt.width", "axis.span")


@pytest.fixture(scope="module")
def relative() -> np.ndarray:
    """Sensitivities: mode 1 depends most on the width for x > 0.2, else on the mass; mode 2 on the span."""
    found = np.zeros((5, 3, 3, 2))
    found[..., 0, 0], found[..., 1, 0] = -0.4, np.where(np.arange(5) > 2, 0.5, 0.2)[:, None]
    found[..., 2, 1] = -0.9
    found[4, :, 2, 1] = -50.0  # at the edge it grows without bound
    found[0, 0] = np.nan
    return found


def test_the_table_of_influences_has_medians_the_largest_first(relative: np.ndarray) -> None:
    figure = figure_of(influence.influence_table(PATHS, relative))
    axes = figure.axes[0]
    assert [label.get_text() for label in axes.get_yticklabels()] == [
        "axis.span",
        "platform.mass",
        "belt.width",
    ]
    assert [label.get_text() for label in axes.get_xticklabels()] == ["mode 1", "mode 2"]
    expected = np.array([[0.0, -0.9], [-0.4, 0.0], [0.2, 0.0]])
    np.testing.assert_allclose(np.asarray(axes.images[0].get_array()), expected)
    assert axes.images[0].get_clim() == (-0.9, 0.9)
    written = {text.get_position(): float(text.get_text().replace("\u2212", "-")) for text in axes.texts}
    assert written == {(k, i): expected[i, k] for i in range(3) for k in range(2)}


def test_the_dominant_parameter_has_its_colour_at_each_pose(plane: Plane, relative: np.ndarray) -> None:
    figure = figure_of(dominant_parameters(plane, PATHS, relative))
    (legend,) = figure.legends
    patches = zip(legend.get_texts(), legend.get_patches(), strict=True)
    colours = {text.get_text(): to_rgba(patch.get_facecolor()) for text, patch in patches}
    colours = {name.partition("  ")[2]: colour for name, colour in colours.items()}
    assert set(colours) == set(PATHS)
    found = panels(figure)
    for i, j in np.argwhere(np.isfinite(PLACE)):
        for name, path in (
            ("mode 1", "belt.width" if i > 2 else "platform.mass"),
            ("mode 2", "axis.span"),
        ):
            mesh = mesh_of(found[name])
            assert to_rgba(mesh.to_rgba(mesh.get_array())[i, j]) == pytest.approx(colours[path]), (i, j)
    assert all(np.isnan(shown(axes)[0, 0]) for axes in found.values())


def test_condition_number_and_outlines_of_the_volume(plane: Plane) -> None:
    """The volume is a box from x = 0.1 to 0.3 and y = -0.05 to 0.1, at two of three heights."""
    heights, along, across = (
        np.array([-0.3, -0.2, -0.1]),
        np.linspace(0.0, 0.4, 41),
        np.linspace(-0.1, 0.2, 31),
    )
    inside = (along[:, None] > 0.1) & (along[:, None] < 0.3) & (across > -0.05) & (across < 0.1)
    volume = ReachableVolume(heights, along, across, np.stack([inside, np.zeros_like(inside), inside]))
    figure = figure_of(workspace(plane, volume))
    assert plane_location(plane) == "z = \u2212200 mm"
    (flat,) = maps_of(figure)
    np.testing.assert_array_equal(shown(flat), PLACE)
    np.testing.assert_allclose(mesh_of(flat).get_clim(), TENTH)
    # 14 poses, each of 0.1 m by 0.1 m.
    assert title(flat) == f"median {np.median(PLACE[np.isfinite(PLACE)]):.2f}\nover 0.14 m\u00b2"
    (solid,) = (axes for axes in figure.axes if axes.name == "3d")
    assert (solid.get_xlabel(), solid.get_ylabel(), solid.get_zlabel()) == ("y [mm]", "x [mm]", "z [mm]")
    outlines = [np.array(line.get_data_3d()) for line in solid.lines]
    assert [set(line[2]) for line in outlines] == [{-300.0}, {-100.0}]
    for line in outlines:
        np.testing.assert_allclose(line[:2].min(axis=1), [-50.0, 100.0], atol=10.0)  # a step of the grid
        np.testing.assert_allclose(line[:2].max(axis=1), [100.0, 300.0], atol=10.0)


def test_shards_of_a_volume_are_left_out(plane: Plane) -> None:
    along, across = np.linspace(0.0, 0.4, 81), np.linspace(-0.1, 0.2, 61)
    inside = (along[:, None] > 0.1) & (along[:, None] < 0.3) & (across > -0.05) & (across < 0.1)
    shard = (along[:, None] > 0.35) & (along[:, None] < 0.37) & (across > 0.15) & (across < 0.18)
    volume = ReachableVolume(np.array([-0.3, -0.1]), along, across, np.stack([inside | shard, shard]))
    figure = figure_of(workspace(plane, volume))
    (solid,) = (axes for axes in figure.axes if axes.name == "3d")
    assert len(solid.lines) == 1


def of_modes(plane: Plane, count: int, *, tall: bool = True) -> Plane:
    """Return a plane with more modes, the same two again and again."""
    dataset = plane.dataset[["frequency", "valid"]]
    if not tall:
        wide = {"y": ("y", 5.0 * Y, {"units": "m"}), "x": ("x", X, {"units": "m"})}
        dataset = dataset.assign_coords(wide)
    parts = [dataset.isel(mode=[i % 2]).assign_coords(mode=[i + 1]) for i in range(count)]
    return Plane(xarray.concat(parts, "mode", data_vars="minimal"), "y", "x", "z", -0.2)


@pytest.mark.parametrize(
    ("modes", "tall", "shape"),
    [
        *((2, False, (1, 2)), (3, False, (1, 3)), (4, False, (2, 2)), (5, False, (2, 3)), (6, False, (2, 3))),
        *((7, False, (2, 4)), (8, False, (2, 4)), (9, False, (3, 3)), (6, True, (1, 6)), (7, True, (2, 4))),
    ],
)
def test_panels_stand_in_rows_of_about_the_same_length(
    modes: int, tall: bool, shape: tuple[int, int]
) -> None:
    assert rows_and_columns(modes, is_tall=tall) == shape
    assert shape[0] * shape[1] - modes < shape[1]  # no row is empty


def test_a_small_range_of_frequencies_looks_small_and_is_said(plane: Plane) -> None:
    """From 100.1 to 100.3 Hz over 5 % of 100 Hz, instead of over all colours."""
    dataset = plane.dataset.assign(frequency=100.0 + 0.01 * (plane.dataset["frequency"] - 90.0))
    assert float(dataset["frequency"].sel(mode=1).max() - dataset["frequency"].sel(mode=1).min()) < 0.5
    found = panels(figure_of(maps.frequencies(Plane(dataset, "y", "x", "z", -0.2))))
    low, high = mesh_of(found["mode 1"]).get_clim()
    assert high - low == pytest.approx(0.05 * (low + high) / 2)
    first, last = 100.1 + 0.01 * np.array(INNER)
    assert f"{first:.2f}\u2013{last:.2f} Hz" in [text.get_text() for text in found["mode 1"].texts]


@pytest.mark.parametrize("tall", [True, False])
def test_scales_have_three_ticks_or_more_that_are_apart(plane: Plane, tall: bool) -> None:
    figure = figure_of(maps.frequencies(of_modes(plane, 6 if tall else 2, tall=tall)))
    with figure_style():
        figure.draw_without_rendering()
    bars = [axes for axes in figure.axes[0].child_axes + figure.axes if "f [Hz]" in labels_of(axes)]
    assert bars
    for bar in bars:
        axis = bar.xaxis if bar.get_xlabel() else bar.yaxis
        low, high = axis.get_view_interval()
        shown = [label for label in axis.get_ticklabels() if low <= place_of(label, axis) <= high]
        assert len(shown) >= 3
        boxes = [label.get_window_extent() for label in shown]
        assert not any(one.overlaps(other) for one, other in pairwise(boxes))


def labels_of(axes: Any) -> tuple[str, str]:
    return axes.get_xlabel(), axes.get_ylabel()


def place_of(label: Any, axis: Any) -> float:
    return float(label.get_position()[0 if axis.axis_name == "x" else 1])


def test_contours_have_their_numbers_apart_from_one_another(plane: Plane) -> None:
    figure = figure_of(maps.frequencies(of_modes(plane, 2, tall=False)))
    with figure_style():
        figure.draw_without_rendering()
    for axes in panels(figure).values():
        (lines,) = (one for one in axes.collections if isinstance(one, ContourSet))
        written = {float(text.get_text()) for text in lines.labelTexts}
        assert written
        assert written <= set(lines.levels.tolist())
        boxes = [text.get_window_extent() for text in lines.labelTexts]
        assert not any(one.overlaps(other) for i, one in enumerate(boxes) for other in boxes[:i])


def test_lines_of_directions_can_be_seen_on_every_colour_also_in_grey(varied: Plane) -> None:
    figure = figure_of(maps.directions(varied))
    for axes in panels(figure).values():
        (strokes,) = (one for one in axes.collections if isinstance(one, LineCollection))
        assert to_rgba(strokes.get_colors()[0]) == (0.0, 0.0, 0.0, 1.0)
        for share in (0.0, 0.5, 1.0):
            colour = np.array(mesh_of(axes).to_rgba(share)[:3])
            linear = np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)
            contrast = (linear @ [0.2126, 0.7152, 0.0722] + 0.05) / 0.05
            assert contrast > 4.5, share


def test_what_is_the_same_everywhere_is_a_sentence(plane: Plane) -> None:
    flat = {"y": ("y", Y, {"units": "m"}), "x": ("x", X, {"units": "m"})}
    ones = xarray.ones_like(plane.dataset["condition"])
    same = plane.dataset.assign(frequency=ones * xarray.DataArray([40.0, 60.0], dims="mode"), condition=ones)
    planar = Plane(same.assign_coords(flat), "y", "x", None, 0.0)
    level = Plane(same.assign_coords(flat), "y", "x", "z", -0.2)
    assert maps.frequencies(planar) == (
        "Every frequency is the same within 0.025 % at every pose: 40.00, 60.00 Hz."
    )
    assert (
        maps.directions(planar)
        == "In each mode the direction of motion of the platform is almost the same at every pose."
    )
    assert (
        maps.components(planar)
        == "In each mode the motion of the platform has almost the same size at every pose."
    )
    assert workspace(planar, None) == ("The condition number of the platform Jacobian is 1 at every pose.")
    assert neighbouring_mac(planar, np.full((5, 3, 2), 0.9994)) == (
        "No mode shape changes abruptly: the smallest MAC of a mode with the mode of the same number at a "
        "neighbouring pose is 0.999."
    )
    assert not isinstance(
        workspace(level, ReachableVolume(np.array([-0.3, -0.1]), X, Y, np.zeros((2, 5, 3), bool))), str
    )


def test_a_panel_with_none_below_it_has_its_labels(plane: Plane) -> None:
    """Five modes of a wide map stand in rows of three: below mode 3 there is nothing."""
    found = panels(figure_of(maps.frequencies(of_modes(plane, 5, tall=False))))
    assert {name: axes.get_xlabel() for name, axes in found.items()} == {
        **dict.fromkeys(("mode 1", "mode 2"), ""),
        **dict.fromkeys(("mode 3", "mode 4", "mode 5"), "y [mm]"),
    }
    assert [axes.get_ylabel() for axes in found.values()] == ["x [mm]", "", "", "x [mm]", ""]


@pytest.mark.parametrize("frequencies", [(124.37, 131.6), (162.0, 562.0), (40.6, 49.0)])
def test_numbers_at_the_scales_of_six_panels_in_a_row_do_not_touch(
    plane: Plane, frequencies: tuple[float, float]
) -> None:
    low, high = frequencies
    dataset = of_modes(plane, 6).dataset
    place = dataset["frequency"] - 100.0 * (2 - dataset["mode"] % 2)
    share = (place - INNER[0]) / (INNER[1] - INNER[0])
    dataset = dataset.assign(frequency=low + (high - low) * share)
    figure = figure_of(maps.frequencies(Plane(dataset, "y", "x", "z", -0.2)))
    with figure_style():
        figure.draw_without_rendering()
        bar = figure.axes[0].child_axes[0]
        low, high = bar.get_xlim()
        shown = [text for text in bar.get_xticklabels() if low <= text.get_position()[0] <= high]
        boxes = [text.get_window_extent() for text in shown]
    assert len(shown) >= 2
    assert all(other.x0 - one.x1 > 0.03 * figure.dpi for one, other in pairwise(boxes))


@pytest.mark.parametrize("stretch", [1.0, 3.0])
def test_on_a_narrow_screen_titles_ranges_labels_and_scales_lie_below_each_other(
    plane: Plane, stretch: float
) -> None:
    """Three columns of a slender plane leave so little width that the numbers of an axis are turned."""
    dataset = of_modes(plane, 6).dataset
    dataset = dataset.assign_coords(x=("x", stretch * X, {"units": "m"}))
    drawing = maps.frequencies(Plane(dataset, "y", "x", "z", -0.2))
    assert isinstance(drawing, Drawing)
    with figure_style():
        sheet = drawing.sheet(narrow=True)
        assert sheet.lay_out_narrow() is not None
        figure = sheet.figure
        assert figure.get_tightbbox().width <= figure.get_figwidth() == NARROW_WIDTH
        for axes in panels(figure).values():
            (written,) = (text for text in axes.texts if text.get_text().endswith("Hz"))
            (bar,) = axes.child_axes
            parts = [
                axes._left_title.get_window_extent(),
                written.get_window_extent(),
                axes.bbox,
                axes.xaxis.label.get_window_extent(),
                bar.get_window_extent(),
                bar.xaxis.label.get_window_extent(),
            ]
            assert all(upper.y0 >= lower.y1 for upper, lower in pairwise(parts))
