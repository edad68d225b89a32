"""What the figures of a plane draw, read back from the drawing: a made-up map whose values say where they belong."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import xarray
from matplotlib.collections import LineCollection, QuadMesh
from matplotlib.colors import to_rgba
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure

from pkmodes.plots import influence, maps
from pkmodes.plots.mac_map import neighbouring_mac
from pkmodes.plots.plane import Plane, where
from pkmodes.plots.style import styled
from pkmodes.plots.workspace import Volume, workspace

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
    with styled():
        figure = maps.frequencies(plane, np.array([[-500.0, 100.0], [20.0, 900.0]]))
    found = panels(figure)
    assert list(found) == ["mode 1", "mode 2"]
    for number, axes in enumerate(found.values(), start=1):
        np.testing.assert_array_equal(shown(axes), PLACE + 100.0 * number)
        edges = mesh_of(axes).get_coordinates()
        np.testing.assert_allclose(edges[0, :, 0], [-150.0, -50.0, 50.0, 150.0])  # y [mm], across
        np.testing.assert_allclose(edges[:, 0, 1], np.arange(-50.0, 451.0, 100.0))  # x [mm], upwards
        assert axes.get_ylim() == pytest.approx((-50.0, 450.0))
        np.testing.assert_allclose(mesh_of(axes).get_clim(), np.array(INNER) + 100.0 * number)
        # On the centre line, but not at its ends.
        assert marks(axes, "v") == [pytest.approx((0.0, 100.0))]
        assert marks(axes, "^") == [pytest.approx((0.0, 300.0))]
        # Motors beyond the map are at its edge.
        assert marks(axes, "s") == [pytest.approx((-150.0, 100.0)), pytest.approx((20.0, 450.0))]
    assert found["mode 1"].get_xlabel() == "y [mm]"
    assert found["mode 1"].get_ylabel() == "x [mm]"


def test_lines_point_along_the_motion_and_colours_are_its_share_along_the_normal(plane: Plane) -> None:
    with styled():
        figure = maps.directions(plane)
    found = panels(figure)
    assert plane.normal == "z"
    assert "share of the motion along z [1]" in [axes.get_ylabel() for axes in figure.axes]
    for name, share, half in (("mode 1", 0.8, (0.0, 27.0)), ("mode 2", 0.0, (45.0, 0.0))):
        axes = found[name]
        values = shown(axes)
        np.testing.assert_allclose(values[np.isfinite(PLACE)], share, atol=1e-9)
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
            np.abs(np.diff(ends, axis=1))[:, 0], np.tile(2.0 * np.array(half), (14, 1))
        )


def test_components_are_drawn_on_one_scale(plane: Plane) -> None:
    with styled():
        figure = maps.components(plane)
    drawn = maps_of(figure)
    assert [axes.get_ylabel() for axes in drawn] == ["in plane\nx [mm]", "", "along z\nx [mm]", ""]
    assert [title(axes) for axes in drawn] == ["mode 1", "mode 2", "", ""]
    for axes, value in zip(drawn, (0.3, 0.5, 0.4, 0.0), strict=True):
        np.testing.assert_allclose(shown(axes)[np.isfinite(PLACE)], value)
        np.testing.assert_allclose(mesh_of(axes).get_clim(), (0.0, 0.5))


def test_each_mode_has_its_mac(plane: Plane) -> None:
    values = np.stack([PLACE / 100.0, 1.0 - PLACE / 100.0], axis=-1)
    with styled():
        found = panels(neighbouring_mac(plane, values))
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
    with styled():
        figure = influence.table(PATHS, relative)
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
    with styled():
        figure = influence.dominant(plane, PATHS, relative)
    (legend,) = figure.legends
    patches = zip(legend.get_texts(), legend.get_patches(), strict=True)
    colours = {text.get_text(): to_rgba(patch.get_facecolor()) for text, patch in patches}
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
    volume = Volume(heights, along, across, np.stack([inside, np.zeros_like(inside), inside]))
    with styled():
        figure = workspace(plane, volume)
    assert where(plane) == "z = \u2212200 mm"
    (flat,) = maps_of(figure)
    np.testing.assert_array_equal(shown(flat), PLACE)
    np.testing.assert_allclose(mesh_of(flat).get_clim(), TENTH)
    assert title(flat) == f"mean {PLACE[np.isfinite(PLACE)].mean():.2f}"
    (solid,) = (axes for axes in figure.axes if axes.name == "3d")
    assert (solid.get_xlabel(), solid.get_ylabel(), solid.get_zlabel()) == ("y [mm]", "x [mm]", "z [mm]")
    outlines = [one for one in solid.collections if isinstance(one, ContourSet)]
    assert len(outlines) == 2
    for outline in outlines:
        corners = np.concatenate([path.vertices for path in outline.get_paths()])
        np.testing.assert_allclose(corners.min(axis=0), [-50.0, 100.0], atol=10.0)  # a step of the grid
        np.testing.assert_allclose(corners.max(axis=0), [100.0, 300.0], atol=10.0)


def test_a_panel_with_none_below_it_has_its_labels(plane: Plane) -> None:
    """Four modes of a wide map stand in rows of three: below modes 2 and 3 there is nothing."""
    wide = {"y": ("y", 5.0 * Y, {"units": "m"}), "x": ("x", X, {"units": "m"})}
    dataset = plane.dataset[["frequency", "valid"]].assign_coords(wide)
    four = xarray.concat([dataset, dataset.assign_coords(mode=[3, 4])], "mode", data_vars="minimal")
    with styled():
        found = panels(maps.frequencies(Plane(four, "y", "x", "z", -0.2)))
    assert {name: axes.get_xlabel() for name, axes in found.items()} == {
        "mode 1": "",
        **dict.fromkeys(("mode 2", "mode 3", "mode 4"), "y [mm]"),
    }
    assert [axes.get_ylabel() for axes in found.values()] == ["x [mm]", "", "", "x [mm]"]
