"""Frequencies against a swept parameter or along a list of poses, and their scatter over sampled robots."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import short_label
from pkmodes.pages.plots.sheet import Sheet
from pkmodes.pages.plots.style import BLUE, GREY, PALETTE, VERMILLION

if TYPE_CHECKING:
    import xarray

    from pkmodes.machine.maps.pose_path import PosePath

Array = NDArray[Any]
#: Maximum number of pose names under an axis.
MAX_POSE_LABELS = 24
#: Below this number of values, 2 % of them are less than one value, and the band covers all of them.
FEW_VALUES = 50
#: Probabilities of the quantiles that a band and its line show, for many values and for few.
INNER_PROBABILITIES, FULL_PROBABILITIES = (0.02, 0.5, 0.98), (0.0, 0.5, 1.0)


def against_axis(dataset: xarray.Dataset, axis: str, spread: Array | None = None) -> Drawing:
    """Draw the frequency of each mode against one axis of a map: median and range over all other axes.

    The band leaves out the lowest and the highest 2 % of many values, as the table of a map does: a few poses at the
    edge of the workspace would otherwise determine the scale.

    - dataset: a map
    - axis: a swept parameter, in SI units, or a component of the pose, in display units
    - spread: standard deviations of the frequencies along the axis, (values, modes) [Hz], as a band; for a map
      without other axes
    """
    order = np.argsort(dataset[axis].values, kind="stable")
    dataset = dataset.isel({axis: order})
    unit, factor = dataset[axis].attrs["units"], 1.0
    if "." not in axis:  # a component of the pose
        unit, factor = DISPLAY_UNITS[unit]
    values = dataset[axis].values * factor
    frequency = _frequencies_by_value(dataset, axis)
    probabilities = FULL_PROBABILITIES if frequency.shape[1] < FEW_VALUES else INNER_PROBABILITIES
    modes = frequency.shape[-1]
    columns = min(modes, 3)
    height = 1.75 * -(-modes // columns) + 0.2

    def draw(sheet: Sheet) -> None:
        sheet.groups(modes, columns, height, share_x=True)
        for mode, panel in enumerate(sheet.panels):
            low, median, high = _quantiles(frequency[..., mode], probabilities)
            if spread is not None:
                low, high = median - spread[order, mode], median + spread[order, mode]
            panel.band(values, low, high, color=BLUE, alpha=0.18, linewidth=0)
            panel.plot(values, median, color=BLUE, marker="o" if len(values) <= 15 else None)
            panel.label(f"mode {mode + 1}", x=f"{axis} [{unit}]", y="f [Hz]")
            if "x" not in panel.omitted_labels:
                panel.axes.tick_params(labelbottom=True)

    return Drawing(draw)


def along_poses(dataset: xarray.Dataset, spread: Array | None = None) -> Drawing:
    """Draw the frequencies along a list of poses.

    - dataset: a map with the dimension ``pose``
    - spread: standard deviations of the frequencies, (poses, modes) [Hz], as bands
    """
    frequencies = _frequencies_by_value(dataset, "pose")
    median_frequencies = np.stack(
        [_quantiles(frequencies[..., mode], (0.5,))[0] for mode in range(frequencies.shape[-1])], axis=-1
    )
    labels = [short_label(label) for label in dataset["pose"].values]
    step = max(1, -(-len(labels) // MAX_POSE_LABELS))
    positions = np.arange(len(labels))

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.0)
        for mode in range(median_frequencies.shape[-1]):
            colour = PALETTE[mode % len(PALETTE)]
            style = "-" if mode < len(PALETTE) else "--"
            marker = "o" if len(labels) <= 60 else None
            if spread is not None:
                low, high = (median_frequencies[:, mode] + side * spread[:, mode] for side in (-1.0, 1.0))
                panel.band(positions, low, high, color=colour, alpha=0.18, linewidth=0)
            panel.plot(
                positions,
                median_frequencies[:, mode],
                style,
                color=colour,
                marker=marker,
                label=f"mode {mode + 1}",
            )
        rotation = 90 if len(labels) > 10 else 0
        panel.set_tick_names("x", range(0, len(labels), step), labels[::step], rotation=rotation)
        panel.label(x="pose", y="f [Hz]")
        sheet.legend(panel, above_panel=False, loc="outside right upper")

    return Drawing(draw)


def along_path(dataset: xarray.Dataset, path: PosePath, spread: Array | None = None) -> Drawing:
    """Draw the frequencies of all modes over the distance along a path, with its corners.

    - dataset: a map of the poses of the path
    - spread: standard deviations of the frequencies, (poses, modes) [Hz], as bands
    """
    frequencies = _frequencies_by_value(dataset, "pose")
    modes = frequencies.shape[-1]
    median_frequencies = np.stack(
        [_quantiles(frequencies[..., mode], (0.5,))[0] for mode in range(modes)], axis=-1
    )

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(3.4)
        for corner in path.corners[1:-1]:
            panel.vertical_line(float(corner), "corner", color=GREY, linestyle="--", linewidth=0.8)
        for mode in range(modes):
            colour, style = PALETTE[mode % len(PALETTE)], "-" if mode < len(PALETTE) else "--"
            values = median_frequencies[:, mode]
            if spread is not None:
                low, high = values - spread[:, mode], values + spread[:, mode]
                panel.band(path.distance, low, high, color=colour, alpha=0.18, linewidth=0)
            panel.plot(path.distance, values, style, color=colour, label=f"mode {mode + 1}")
        panel.axes.set_xlim(float(path.distance[0]), float(path.distance[-1]))
        panel.axes.set_ylim(0.0, None)
        panel.label(x=f"distance along the path [{path.unit}]", y="f [Hz]")
        sheet.legend(panel, above_panel=False, loc="outside right upper")

    return Drawing(draw)


def sample_scatter(dataset: xarray.Dataset) -> Drawing:
    """Draw by how much the frequencies of sampled robots differ from the median robot at the same pose.

    - dataset: a map with the dimension ``sample``
    """
    frequency = _frequencies_by_value(dataset, "sample")
    modes = frequency.shape[-1]
    median = [_quantiles(frequency[..., mode].T, (0.5,))[0] for mode in range(modes)]
    relative_differences = 100.0 * (frequency / np.stack(median, axis=-1) - 1.0)

    def draw(sheet: Sheet) -> None:
        panel = sheet.panel(2.6)
        panel.axes.axhline(0.0, color=GREY, linewidth=0.8)
        for mode in range(modes):
            values = relative_differences[..., mode][np.isfinite(relative_differences[..., mode])]
            if not len(values):
                continue
            position = [mode + 1] * 2
            low, quarter, median, three_quarters, high = np.quantile(values, [0.025, 0.25, 0.5, 0.75, 0.975])
            panel.plot(position, [low, high], color=BLUE, linewidth=1.2)
            panel.plot(position, [quarter, three_quarters], color=BLUE, linewidth=7, solid_capstyle="butt")
            panel.plot([mode + 1], [median], "o", color=VERMILLION)
        panel.axes.set_xticks(range(1, modes + 1))
        panel.axes.set_xlim(0.5, modes + 0.5)
        panel.label(x="mode", y="f / median at the pose \u2212 1 [%]")

    return Drawing(draw)


def _frequencies_by_value(dataset: xarray.Dataset, dim: str) -> Array:
    """Return the frequencies as (values of a dimension, all other dimensions, modes)."""
    frequencies = dataset["frequency"].transpose(dim, ..., "mode").values
    return frequencies.reshape(frequencies.shape[0], -1, frequencies.shape[-1])


def _quantiles(values: Array, probabilities: tuple[float, ...]) -> Array:
    """Return quantiles along the second axis, NaN where no pose can be evaluated."""
    quantiles = np.full((len(probabilities), len(values)), np.nan)
    has_value = np.isfinite(values).any(axis=1)
    if has_value.any():
        quantiles[:, has_value] = np.nanquantile(values[has_value], probabilities, axis=1)
    return quantiles
