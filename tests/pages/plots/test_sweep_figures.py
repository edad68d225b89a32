"""Frequencies against parameters, along poses and over samples, read back from the drawing: medians by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray

from pkmodes.pages.plots import sweeps
from pkmodes.pages.plots.style import PALETTE


def map_of(dims: tuple[str, ...], frequency: np.ndarray, **coordinates: Any) -> xarray.Dataset:
    """Return a made-up map with a second mode 100 Hz above the first."""
    both = np.stack([frequency, frequency + 100.0], axis=-1)
    return xarray.Dataset({"frequency": ((*dims, "mode"), both)}, {**coordinates, "mode": [1, 2]})


def test_the_line_is_the_median_and_the_band_the_range_in_the_order_of_the_values() -> None:
    # Heavier first; a pose that cannot be evaluated counts in neither.
    frequency = np.array([[5.0, 30.0, 7.0, np.nan], [10.0, 60.0, 20.0, np.nan]])
    masses = {"link.mass": ("link.mass", [2.0, 1.0], {"units": "kg"})}
    figure = sweeps.against_axis(map_of(("link.mass", "pose"), frequency, **masses), "link.mass").figure
    assert [axes.get_title(loc="left") for axes in figure.axes] == ["mode 1", "mode 2"]
    for above, axes in zip((0.0, 100.0), figure.axes, strict=True):
        (line,) = axes.lines
        np.testing.assert_allclose(line.get_xdata(), [1.0, 2.0])
        np.testing.assert_allclose(line.get_ydata(), [20.0 + above, 7.0 + above])
        (band,) = axes.collections
        corners = {tuple(corner) for corner in band.get_paths()[0].vertices.tolist()}
        assert corners == {(x, y + above) for x, y in ((1.0, 10.0), (1.0, 60.0), (2.0, 5.0), (2.0, 30.0))}
        assert axes.get_xlabel() == "link.mass [kg]"
    assert figure.axes[0].get_ylabel() == "f [Hz]"


def test_along_poses_each_mode_is_a_line_of_medians_over_everything_else() -> None:
    # Three robots at two poses.
    frequency = np.array([[10.0, 50.0], [12.0, 90.0], [40.0, 60.0]])
    poses = {"pose": ("pose", ["A", "B"])}
    figure = sweeps.along_poses(map_of(("link.mass", "pose"), frequency, **poses)).figure
    (axes,) = figure.axes
    assert [label.get_text() for label in axes.get_xticklabels()] == ["A", "B"]
    for line, name, colour, values in zip(
        axes.lines, ("mode 1", "mode 2"), PALETTE[:2], ([12.0, 60.0], [112.0, 160.0]), strict=True
    ):
        assert line.get_label() == name
        assert line.get_color() == colour
        np.testing.assert_allclose(line.get_xdata(), [0.0, 1.0])
        np.testing.assert_allclose(line.get_ydata(), values)


def test_the_scatter_of_samples_is_relative_to_the_median_at_the_same_pose_in_per_cent() -> None:
    """Samples at -2 to 2 % of 100 Hz and of 50 Hz: the same scatter, whatever the pose."""
    percent = np.array([1.0, -2.0, 0.0, 2.0, -1.0])
    frequency = np.stack([100.0 + percent, 50.0 + 0.5 * percent], axis=1)
    dataset = map_of(("sample", "pose"), frequency)
    dataset["frequency"][..., 1] = 3.0 * frequency  # mode 2 scatters alike
    figure = sweeps.sample_scatter(dataset).figure
    (axes,) = figure.axes
    assert "[%]" in axes.get_ylabel()
    for mode in (1, 2):
        thin, thick, median = (
            line
            for line in axes.lines
            if len(line.get_xdata()) < 3 and set(np.ravel(line.get_xdata())) == {mode}
        )
        # Quantiles of the ten values -2, -2, -1, -1 ... 2, 2.
        np.testing.assert_allclose(thin.get_ydata(), [-2.0, 2.0], atol=1e-9)
        np.testing.assert_allclose(thick.get_ydata(), [-1.0, 1.0], atol=1e-9)
        np.testing.assert_allclose(median.get_ydata(), 0.0, atol=1e-9)
        assert thick.get_linewidth() > 3 * thin.get_linewidth()


def test_the_band_of_many_poses_leaves_out_the_extremes() -> None:
    """Of 101 poses, 0 to 99 Hz and one far above, the band shows 2 to 98 Hz."""
    frequency = np.append(np.arange(100.0), 5000.0)[None].repeat(2, axis=0)
    masses = {"link.mass": ("link.mass", [1.0, 2.0], {"units": "kg"})}
    figure = sweeps.against_axis(map_of(("link.mass", "pose"), frequency, **masses), "link.mass").figure
    heights = figure.axes[0].collections[0].get_paths()[0].vertices[:, 1]
    np.testing.assert_allclose([heights.min(), heights.max()], [2.0, 98.0])
