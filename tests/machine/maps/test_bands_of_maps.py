"""Bands of the frequencies in figures of maps, from the standard deviations of the robot file."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from pkmodes.machine.maps.spread import spread_along
from pkmodes.pages.figures import pictures
from pkmodes.pages.plots import sweeps
from pkmodes.pages.report.map import map_report

PRINTER = "robots/corexy-printer.toml"


def by_differences(model: pkmodes.Model, pose: list[float], without: tuple[str, ...] = ()) -> np.ndarray:
    squares = np.zeros(2)
    for path, quantity in model.robot.quantities.items():
        if quantity.sigma and path not in without:
            h = 1e-3 * quantity.sigma
            up, down = (
                model.with_values({path: quantity.value + step}).frequencies(pose)[-2:] for step in (h, -h)
            )
            squares += (quantity.sigma * (up - down) / (2.0 * h)) ** 2
    return np.sqrt(squares)


def test_along_a_line_and_along_poses() -> None:
    model = pkmodes.load(PRINTER)
    x = [0.05, 0.1, 0.25]
    expected = [by_differences(model, [value, 0.15]) for value in x]
    line = model.map({"x": x, "y": 0.15})
    found = spread_along(model.robot, line, "x", model.max_condition)
    np.testing.assert_allclose(found, expected, rtol=1e-5)
    poses = model.map([[value, 0.15] for value in x])
    found = spread_along(model.robot, poses, "pose", model.max_condition)
    np.testing.assert_allclose(found, expected, rtol=1e-5)


def test_a_swept_value_is_known() -> None:
    model = pkmodes.load(PRINTER)
    masses = [0.4, 0.5, 0.7]
    swept = model.map({"x": 0.1, "y": 0.15}, sweep={"toolhead.mass": masses})
    found = spread_along(model.robot, swept, "toolhead.mass", model.max_condition)
    expected = [
        by_differences(model.with_values({"toolhead.mass": mass}), [0.1, 0.15], ("toolhead.mass",))
        for mass in masses
    ]
    np.testing.assert_allclose(found, expected, rtol=1e-5)


def test_tracked_modes_have_their_own() -> None:
    """Where two modes cross, the map numbers them by shape, and so are their bands."""
    model = pkmodes.load(PRINTER)
    line = model.map({"x": [0.1, 0.2], "y": 0.15})
    crossed = line.copy(deep=True)
    second = line["frequency"].sel(x=0.2)
    crossed["frequency"].loc[{"x": 0.2}] = second.values[..., ::-1]
    found = spread_along(model.robot, line, "x", model.max_condition)
    other = spread_along(model.robot, crossed, "x", model.max_condition)
    assert found is not None
    assert other is not None
    np.testing.assert_array_equal(other, [found[0], found[1][::-1]])


def test_three_modes_in_another_order_have_their_own() -> None:
    """An order that is not its own inverse."""
    model = pkmodes.load("robots/clavel-delta.toml")
    line = model.map({"x": [0.05, 0.1], "y": 0.03, "z": -0.6})
    turned = line.copy(deep=True)
    turned["frequency"].values[...] = np.roll(line["frequency"].values, 1, axis=-1)
    found, other = (spread_along(model.robot, one, "x", model.max_condition) for one in (line, turned))
    assert found is not None
    np.testing.assert_array_equal(other, np.roll(found, 1, axis=-1))


def test_there_is_none_with_further_axes_samples_or_without_sigmas() -> None:
    model = pkmodes.load(PRINTER)
    plane = model.map({"x": [0.1, 0.2], "y": [0.1, 0.2]})
    assert spread_along(model.robot, plane, "x", model.max_condition) is None
    drawn = model.map({"x": [0.1, 0.2], "y": 0.1}, samples=2)
    assert spread_along(model.robot, drawn, "x", model.max_condition) is None
    other = pkmodes.load("robots/linear-delta-2022.toml")
    line = other.map({"x": [0.5, 0.6], "y": 0.0, "z": -0.245})
    assert spread_along(other.robot, line, "x", other.max_condition) is None


def test_the_figures_have_them_in_any_order_of_the_axis() -> None:
    model = pkmodes.load(PRINTER)
    poses = model.map([[0.25, 0.15], [0.05, 0.15]])
    spread = np.array([[1.0, 2.0], [3.0, 4.0]])
    frequency = poses["frequency"].values
    (axes,) = sweeps.along_poses(poses, spread).figure.axes
    panels = sweeps.against_axis(model.map({"x": [0.05, 0.25], "y": 0.15}), "x", spread[::-1]).figure.axes
    for mode in (0, 1):
        for vertices in (
            axes.collections[mode].get_paths()[0].vertices,
            panels[mode].collections[0].get_paths()[0].vertices,
        ):
            ends = vertices[:, 1]
            low, high = frequency[:, mode] - spread[:, mode], frequency[:, mode] + spread[:, mode]
            assert ends.min() == pytest.approx(low.min())
            assert ends.max() == pytest.approx(high.max())


@pytest.mark.usefixtures("no_drawing")
def test_the_report_says_what_the_band_is() -> None:
    model = pkmodes.load(PRINTER)
    text = map_report(model, model.map([[0.1, 0.1], [0.2, 0.1]]))
    assert "along the poses: the band is one standard deviation on either side" in text
    # The picture of the frequencies: the median over its plane, 5 % of the frequency from the belts and some more.
    assert "the frequencies of modes 1 and 2 are known to \u00b1" in text


def test_without_sigmas_captions_do_not_change() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml")
    grid = {"x": np.linspace(0.4, 0.8, 5), "y": [-0.05, 0.0, 0.05], "z": -0.245}
    drawn = {picture.name: picture.description for picture in pictures(model, grid)}
    assert "are known to" not in drawn["frequencies"]
